// The hyperbolic sine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// s = sinh x: s' = cosh x x'. Its series and that of cosh x are computed together.
struct sinh_function {
    static constexpr auto kind = function_kind::sinh;
    static constexpr std::string_view name = "sinh";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static range bounds(const number_bounds& x) { return rising_steeply(mpfr_sinh, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(sinh(x))) {
        return R(sinh(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return cosh(x);
    }

    static constexpr bool odd = true;
    static constexpr int kept = 1;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::hyperbolic_sine_cosine_kernel(of.slope, of.result, of.kept[0], n, of.of_slope, sums);
    }
    /// The companion.
    static constexpr int values_kept = 1;
    template <class E, class Call>
    static E first_kept(int /*which*/, const E& x, const Call& call) {
        return call(function_kind::cosh, x);
    }
};

}  // namespace libration::function
