// The sine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// s = sin x: s' = cos x x'. Its series and that of cos x are computed together.
struct sin_function {
    static constexpr auto kind = function_kind::sin;
    static constexpr std::string_view name = "sin";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = times_pi(x);
        return q ? ones(exact_cosine(rational(*q - rational(1, 2)))) : at_zero(x, 0);
    }
    static range bounds(const number_bounds& x) { return of_circle(mpfr_sin, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(sin(x))) {
        return R(sin(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return cos(x);
    }

    static constexpr bool odd = true;
    static constexpr int kept = 1;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::sine_cosine_kernel(of.slope, of.result, of.kept[0], n, of.of_slope, sums);
    }
    /// The companion.
    static constexpr int values_kept = 1;
    template <class E, class Call>
    static E first_kept(int /*which*/, const E& x, const Call& call) {
        return call(function_kind::cos, x);
    }
};

}  // namespace libration::function
