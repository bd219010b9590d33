// The inverse hyperbolic sine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = asinh x: sqrt(1 + x^2) a' = x'.
struct asinh_function {
    static constexpr auto kind = function_kind::asinh;
    static constexpr std::string_view name = "asinh";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static range bounds(const number_bounds& x) { return rising(rounded, x); }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return pow(1 + x * x, E(rational(-1, 2)));
    }

    static constexpr rounded_function rounded = mpfr_asinh;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_asinh(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_asinh(y, x, bits);
    }
};

}  // namespace libration::function
