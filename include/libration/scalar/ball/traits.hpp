// The traits of the scalar `ball`: on balls every result contains the exact one.
#pragma once

#include <vector>

#include "libration/scalar/ball/fraction.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/polynomial.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

/// The precision is that of the current precision_scope, so that balls are their own wide arithmetic.
template <>
struct scalar_traits<ball> : default_scalar_traits<ball> {
    static constexpr bool proved = true;

    static int digits() { return static_cast<int>(ball::working_bits()); }

    static ball pi() {
        ball result;
        arb_const_pi(result.handle(), ball::working_bits());
        return result;
    }

    static ball from_rational(const rational& q) {
        ball result;
        const fraction_parts parts(q);
        arb_fmpz_div_fmpz(result.handle(), parts.above(), parts.below(), ball::working_bits());
        return result;
    }

    /// The ball of all numbers from lower to upper.
    static ball from_bounds(const mpfr& lower, const mpfr& upper) {
        ball result;
        arb_set_interval_mpfr(result.handle(), handle(lower), handle(upper), ball::working_bits());
        return result;
    }

    /// The e with |x| < 2^e for the whole ball, within a factor of 2 if the ball is narrow; exponent_of_zero only for
    /// 0. Throws precision_exhausted for an unbounded ball.
    static long binary_exponent(const ball& x) {
        if (!is_finite(x)) {
            throw precision_exhausted("a size");
        }
        ball largest;
        arb_get_abs_ubound_arf(arb_midref(largest.handle()), x.handle(), ball::working_bits());
        return arb_is_zero(x.handle()) != 0 ? exponent_of_zero
                                            : static_cast<long>(arf_abs_bound_lt_2exp_si(arb_midref(largest.handle())));
    }

    /// The value with its radius enlarged by the largest |bound|.
    static ball enclose(const ball& value, const ball& bound) {
        ball result = value;
        arb_add_error(result.handle(), bound.handle());
        return result;
    }

    static ball midpoint(const ball& x) {
        ball result;
        arf_set(arb_midref(result.handle()), arb_midref(x.handle()));
        return result;
    }

    /// Whether every number of a is below every number of b.
    static bool certainly_less(const ball& a, const ball& b) { return arb_lt(a.handle(), b.handle()) != 0; }

    /// The midpoint rounded to the working precision, with the radius enlarged by the rounding error.
    static ball narrow(const ball& x) {
        ball result;
        arb_set_round(result.handle(), x.handle(), ball::working_bits());
        return result;
    }

    /// In place, with the same roundings as the operators.
    static void horner_step(ball& sum, const ball& x, const ball& next) {
        arb_mul(sum.handle(), sum.handle(), x.handle(), ball::working_bits());
        arb_add(sum.handle(), sum.handle(), next.handle(), ball::working_bits());
    }

    /// With one rounding at the end.
    static ball sum_of_products(const ball* x, int x_step, const ball* y, int y_step, int count) {
        static_assert(sizeof(ball) == sizeof(arb_struct), "FLINT iterates over an array of balls");
        ball sum;
        arb_dot(sum.handle(), nullptr, 0, x->handle(), x_step, y->handle(), y_step, count, ball::working_bits());
        return sum;
    }

    static std::vector<ball> whole_product(const std::vector<ball>& a, const std::vector<ball>& b) {
        return libration::whole_product(a, b);
    }
    static std::vector<ball> whole_quotient(const std::vector<ball>& a, const std::vector<ball>& b) {
        return libration::whole_quotient(a, b);
    }
};

}  // namespace libration
