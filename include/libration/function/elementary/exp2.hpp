// Powers of 2.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// e = 2^x = exp(x log 2), also for the series: e' = log(2) e x'.
struct exp2_function {
    static constexpr auto kind = function_kind::exp2;
    static constexpr std::string_view name = "exp2";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        constexpr int largest = 4096;
        if (!q || denominator(*q) != 1 || abs(*q) > largest) {
            return std::nullopt;
        }
        const rational power(integer(1) << abs(numerator(*q)).convert_to<unsigned>());
        return ones(*q < 0 ? rational(1 / power) : power);
    }
    static range bounds(const number_bounds& x) { return rising_steeply(rounded, x); }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return log(E(2)) * w;
    }
    template <class E>
    static E in_others(const E& x) {
        return exp(log(E(2)) * x);
    }

    static constexpr rounded_function rounded = mpfr_exp2;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        Real factor;
        arb_init(&factor);
        arb_const_log2(&factor, bits + 64);
        arb_mul(&factor, &factor, x, bits + 64);
        arb_exp(y, &factor, bits);
        arb_clear(&factor);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        Complex factor;
        acb_init(&factor);
        acb_set_ui(&factor, 2);
        acb_log(&factor, &factor, bits + 64);
        acb_mul(&factor, &factor, x, bits + 64);
        acb_exp(y, &factor, bits);
        acb_clear(&factor);
    }
};

}  // namespace libration::function
