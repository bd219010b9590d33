// The cube root.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// r = cbrt x, negative for negative x: 3 x r' = r x'.
struct cbrt_function {
    static constexpr auto kind = function_kind::cbrt;
    static constexpr std::string_view name = "cbrt";
    static constexpr std::string_view domain = "all x, in series x != 0";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular{1, {0}, "takes the cube root of 0, where it has no series"};
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        const auto root = q ? exact_root(abs(*q), 3) : std::nullopt;
        return root ? ones(*q < 0 ? rational(-*root) : *root) : std::nullopt;
    }
    static range bounds(const number_bounds& x) { return rising(rounded, x); }

    template <class E>
    static E derivative(const E& x, const E& w) {
        return w / (3 * x);
    }

    static constexpr rounded_function rounded = mpfr_cbrt;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        if (arb_is_zero(x)) {
            arb_zero(y);  // of which arb_root_ui is not a number
        } else if (arb_is_negative(x)) {
            arb_neg(y, x);
            arb_root_ui(y, y, 3, bits);
            arb_neg(y, y);
        } else {
            arb_root_ui(y, x, 3, bits);
        }
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        // The cut is the imaginary axis, so that the values on the real line are real.
        if (arb_is_negative(&x->real)) {
            acb_neg(y, x);
            acb_root_ui(y, y, 3, bits);
            acb_neg(y, y);
        } else {
            acb_root_ui(y, x, 3, bits);
        }
    }
};

}  // namespace libration::function
