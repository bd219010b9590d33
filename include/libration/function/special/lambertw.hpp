// The principal branch of Lambert's W [DLMF 4.13].
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// W e^W = x, W >= -1: w' = exp(-w)/(1 + w) x' [DLMF 4.13.4].
struct lambertw_function {
    static constexpr auto kind = function_kind::lambertw;
    static constexpr std::string_view name = "lambertw";
    static constexpr std::string_view domain = "x >= -1/e, in series x > -1/e";
    static constexpr std::string_view alias = "lambert_w";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    /// At r exp(r) too, which is not a plain number (expression::exponential_form).
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static range bounds(const number_bounds& x) {
        mpfr least;
        mpfr_exp(handle(least), handle(mpfr(-1)), MPFR_RNDU);
        if (x.upper < -least) {
            refuse_number("takes lambertw of a number below -1/e");
        }
        return by_balls(kind, x);
    }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return exp(-w) / (1 + w);
    }

    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_lambertw(y, x, 0, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        const long principal = 0;
        acb_lambertw(y, x, &principal, 0, bits);
    }
};

}  // namespace libration::function
