// Relative exponentials: what remains of exp(x) after n terms, divided by the next one.
#pragma once

#include "libration/function/facts.hpp"
#include "libration/scalar/relative_kind.hpp"

namespace libration::function {

/// The order of a relative exponential: whole and from 1 to 1000. Throws error otherwise.
inline int relative_order(const rational& order) {
    constexpr int largest = 1000;
    if (!is_whole(order) || order < 1 || order > largest) {
        refuse_number("takes a relative function of an order that is not a whole number from 1 to 1000");
    }
    return numerator(order).convert_to<int>();
}

/// w = exprel(n, x) = n! sum_{j>=0} x^j/(j + n)! = n int_0^1 (1 - s)^(n-1) exp(s x) ds, which is (exp(x) - 1)/x for n = 1
/// and 2 (exp(x) - 1 - x)/x^2 for n = 2: w' = (w - n/(n + 1) exprel(n + 1, x)) x', without a division by x. By the
/// integral coefficient j of its series about c is at most exp(max(Re c, 0)) n!/(n + j)! <= exp(max(Re c, 0))/j!.
struct exprel_function {
    static constexpr auto kind = function_kind::exprel;
    static constexpr auto family = relative_kind::exponential;
    static constexpr std::string_view name = "exprel";
    static constexpr bool has_order = true;
    static constexpr std::string_view domain = "all x, for a whole order from 1 to 1000";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static constexpr singular_points without_polynomial_form{
        1, {0}, "takes a quotient with a removable singularity at it, where it has no polynomial form"};
    static exact_value exact(const rational& order, const plain_number& x) {
        return relative_order(order) > 0 ? at_zero(x, 1) : std::nullopt;
    }
    static range bounds(const rational& order, const number_bounds& x) {
        return relative_order(order) > 0 ? by_balls(kind, order, x) : std::nullopt;
    }

    template <class E>
    static E derivative(const rational& order, const E& x, const E& w) {
        return w - E(rational(order / (order + 1))) * exprel(rational(order + 1), x);
    }
    /// By exp(x) and a division by x: exprel(n, x) = n (exprel(n - 1, x) - 1)/x.
    template <class E>
    static E by_division(const rational& order, const E& x) {
        E w = exp(x);
        for (int n = 1; n <= relative_order(order); ++n) {
            w = E(rational(n)) * (w - E(rational(1))) / x;
        }
        return w;
    }
    /// Coefficient j about 0.
    static rational about_zero(int order, int j) {
        rational product = 1;
        for (int i = 1; i <= j; ++i) {
            product /= order + i;
        }
        return product;
    }

    static constexpr bool odd = false;
    /// The derivative; the series of all derivatives are in a table (expansion/step_arrays.hpp).
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
