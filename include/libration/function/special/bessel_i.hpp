// Modified Bessel functions of the first kind [DLMF 10.25].
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// w = I_n(x): x w' = (n w + x I_(n+1)(x)) x' = (x I_(n-1)(x) - n w) x' [DLMF 10.29.2].
struct bessel_i_function {
    static constexpr auto kind = function_kind::bessel_i;
    static constexpr std::string_view name = "bessel_i";
    static constexpr bool has_order = true;
    static constexpr std::string_view domain = "all x for a whole order, else x > 0; in series x != 0";
    static constexpr auto form = analytic_form::entire;  ///< for an integer order, otherwise multivalued
    static constexpr singular_points singular{1, {0}, "takes a Bessel function at 0, a singular point of its equation"};
    static exact_value exact(const rational& order, const plain_number& x) {
        return x.coefficient == 0 && is_whole(order) ? ones(rational(order == 0 ? 1 : 0)) : std::nullopt;
    }
    static range bounds(const rational& order, const number_bounds& x) {
        return is_whole(order) || above({0, false}, x, "takes a Bessel function of a number that is not positive")
                   ? by_balls(kind, order, x)
                   : std::nullopt;
    }

    /// In the pair of orders 2k <= n < 2k + 1 and n + 1, so that each derivative is available from the other.
    template <class E>
    static E derivative(const rational& order, const E& x, const E& w) {
        const E n(order);
        return is_first_of_pair(order) ? n * w / x + bessel_i(rational(order + 1), x)
                                       : bessel_i(rational(order - 1), x) - n * w / x;
    }

    template <class Real>
    static void real_ball(Real* y, const Real* order, const Real* x, long bits) {
        arb_hypgeom_bessel_i(y, order, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* order, const Complex* x, long bits) {
        acb_hypgeom_bessel_i(y, order, x, bits);
    }
};

}  // namespace libration::function
