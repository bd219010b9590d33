// The exponential function.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// e = exp x: e' = e x'.
struct exp_function {
    static constexpr auto kind = function_kind::exp;
    static constexpr std::string_view name = "exp";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 1); }
    static range bounds(const number_bounds& x) { return rising_steeply(mpfr_exp, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(exp(x))) {
        return R(exp(x));
    }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return w;
    }

    static constexpr bool odd = false;
    static constexpr int kept = 0;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::exponential_kernel(of.slope, of.result, n, of.of_slope, sums);
    }
};

}  // namespace libration::function
