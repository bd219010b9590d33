// Relative cosines and sines: the even part of a relative exponential of i x.
#pragma once

#include "libration/function/elementary/exprel.hpp"

namespace libration::function {

/// w = cosrel(n, x) = n! sum_{j>=0} (-1)^j x^(2j)/(2j + n)! = n int_0^1 (1 - s)^(n-1) cos(s x) ds, which is sin(x)/x for n
/// = 1 and 2 (1 - cos(x))/x^2 for n = 2: w' = -x/(n + 1) (cosrel(n + 1, x) - n/(n + 2) cosrel(n + 2, x)) x', without a
/// division by x. By the integral coefficient j of its series about c is at most exp(|Im c|) n!/(n + j)!.
struct cosrel_function {
    static constexpr auto kind = function_kind::cosrel;
    static constexpr auto family = relative_kind::cosine;
    static constexpr std::string_view name = "cosrel";
    static constexpr bool has_order = true;
    static constexpr std::string_view domain = "all x, for a whole order from 1 to 1000";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static constexpr singular_points without_polynomial_form = exprel_function::without_polynomial_form;
    static exact_value exact(const rational& order, const plain_number& x) {
        return relative_order(order) > 0 ? at_zero(x, 1) : std::nullopt;
    }
    static range bounds(const rational& order, const number_bounds& x) {
        return relative_order(order) > 0 ? by_balls(kind, order, x) : std::nullopt;
    }

    template <class E>
    static E derivative(const rational& order, const E& x, const E& /*w*/) {
        const E above = cosrel(rational(order + 1), x);
        return E(rational(-1 / (order + 1))) * x *
               (above - E(rational(order / (order + 2))) * cosrel(rational(order + 2), x));
    }
    /// By sin(x) or cos(x) and divisions by x: cosrel(n, x) = n (n - 1)(1 - cosrel(n - 2, x))/x^2.
    template <class E>
    static E by_division(const rational& order, const E& x) {
        const int last = relative_order(order);
        E w = last % 2 == 0 ? cos(x) : sin(x) / x;
        for (int n = last % 2 == 0 ? 2 : 3; n <= last; n += 2) {
            w = E(rational(n * (n - 1))) * (E(rational(1)) - w) / (x * x);
        }
        return w;
    }
    /// Coefficient j about 0.
    static rational about_zero(int order, int j) {
        const rational size = exprel_function::about_zero(order, j);
        return j % 2 == 1 ? rational(0) : j % 4 == 0 ? size : rational(-size);
    }

    static constexpr bool odd = false;
    static constexpr int kept = 1;
    static constexpr bool has_table = true;

    template <class Real>
    static void real_ball(Real* y, const Real* order, const Real* x, long bits) {
        relative_ball(y, family, order, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* order, const Complex* x, long bits) {
        relative_ball(y, family, order, x, bits);
    }
};

}  // namespace libration::function
