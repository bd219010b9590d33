// sin x / x.
#pragma once

#include "libration/function/elementary/cosrel.hpp"

namespace libration::function {

/// s = sin(x)/x = cosrel(1, x), 1 at x = 0.
struct sinc_function {
    static constexpr auto kind = function_kind::sinc;
    static constexpr std::string_view name = "sinc";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static constexpr singular_points without_polynomial_form{
        1, {0}, "takes sinc of 0, where it has no polynomial form"};
    static exact_value exact(const plain_number& x) { return at_zero(x, 1); }
    static range bounds(const number_bounds& x) { return by_balls(kind, x); }

    template <class E>
    static E derivative(const E& x, const E& w) {
        return cosrel_function::derivative(rational(1), x, w);
    }
    /// By sin(x) and a division by x.
    template <class E>
    static E by_division(const E& x) {
        return sin(x) / x;
    }
    template <class E>
    static E in_others(const E& x) {
        return cosrel(rational(1), x);
    }

    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_sinc(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_sinc(y, x, bits);
    }
};

}  // namespace libration::function
