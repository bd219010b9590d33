// exp x - 1.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// e = exp(x) - 1, without cancellation near 0: e' = (1 + e) x'.
struct expm1_function {
    static constexpr auto kind = function_kind::expm1;
    static constexpr std::string_view name = "expm1";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static range bounds(const number_bounds& x) { return rising_steeply(rounded, x); }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return 1 + w;
    }

    static constexpr rounded_function rounded = mpfr_expm1;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_expm1(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_expm1(y, x, bits);
    }
};

}  // namespace libration::function
