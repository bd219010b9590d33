// The tangent.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// t = tan x: t' = (1 + t^2) x'.
struct tan_function {
    static constexpr auto kind = function_kind::tan;
    static constexpr std::string_view name = "tan";
    static constexpr std::string_view domain = "all x except odd multiples of pi/2";
    static constexpr auto form = analytic_form::one_value;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = times_pi(x);
        return q ? ones(exact_tangent(*q)) : at_zero(x, 0);
    }
    static range bounds(const number_bounds& x) { return quotient(of_circle(mpfr_sin, x), of_circle(mpfr_cos, x)); }

    template <class R>
    static auto value(const R& x) -> decltype(R(tan(x))) {
        return R(tan(x));
    }
    template <class R>
    requires(
        !requires(const R& x) { R(tan(x)); } && requires(const R& x) { R(sin(x) / cos(x)); }) static R
        value(const R& x) {
        return R(sin(x) / cos(x));
    }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return 1 + w * w;
    }

    static constexpr bool odd = true;
    static constexpr int kept = 1;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::tangent_kernel(of.slope, of.kept[0], of.result, n, of.of_x, sums);
    }
};

}  // namespace libration::function
