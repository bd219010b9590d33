// The complementary error function [DLMF 7].
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// w = erfc x = 1 - erf x, without cancellation for large x: w' = -2/sqrt(pi) exp(-x^2) x' [DLMF 7.2.2].
struct erfc_function {
    static constexpr auto kind = function_kind::erfc;
    static constexpr std::string_view name = "erfc";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 1); }
    static range bounds(const number_bounds& x) { return falling(rounded, x); }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return E(-2) / sqrt(E(plain_number{rational(1), unit::pi})) * exp(-(x * x));
    }

    static constexpr rounded_function rounded = mpfr_erfc;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_hypgeom_erfc(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_hypgeom_erfc(y, x, bits);
    }
};

}  // namespace libration::function
