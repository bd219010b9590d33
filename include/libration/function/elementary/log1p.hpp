// log(1 + x).
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// l = log(1 + x), without cancellation near 0: (1 + x) l' = x'.
struct log1p_function {
    static constexpr auto kind = function_kind::log1p;
    static constexpr std::string_view name = "log1p";
    static constexpr std::string_view domain = "x > -1";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static constexpr const char* refusal = "takes log1p of a number that is not above -1";
    static range bounds(const number_bounds& x) {
        const range inside = above({-1, false}, x, refusal);
        return inside ? range(rising(rounded, *inside)) : std::nullopt;
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / (1 + x);
    }

    static constexpr rounded_function rounded = mpfr_log1p;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_log1p(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_log1p(y, x, bits);
    }
};

}  // namespace libration::function
