// Subintervals (pieces) of a step of an integrator: exact ends, and bisection points that favour no scale.
#pragma once

#include <optional>
#include <utility>

#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

/// The common sign of all numbers of a ball; 0 if it contains 0 or is not finite.
inline int known_sign(const ball& x) {
    return arb_is_positive(x.handle()) != 0 ? 1 : arb_is_negative(x.handle()) != 0 ? -1 : 0;
}

/// Exact operations on exact numbers: a < b, a + b, multiplication by 2^exponent.
inline bool exactly_less(const ball& a, const ball& b) {
    return arf_cmp(arb_midref(a.handle()), arb_midref(b.handle())) < 0;
}
inline ball exact_sum(const ball& a, const ball& b) {
    ball result;
    arb_add(result.handle(), a.handle(), b.handle(), ARF_PREC_EXACT);
    return result;
}
inline ball exact_multiple(const ball& a, unsigned long factor, long exponent) {
    ball result;
    arb_mul_ui(result.handle(), a.handle(), factor, ARF_PREC_EXACT);
    arb_mul_2exp_si(result.handle(), result.handle(), exponent);
    return result;
}

/// A power of 2 near sqrt(a b), for exact 0 < 4 a < b, strictly between a and b: with a in [2^(e-1), 2^e) and b in
/// [2^(f-1), 2^f) f is at least e + 2, so that 2^floor((e + f - 1)/2) is at least 2^e and at most 2^(f-2).
inline ball power_between(const ball& a, const ball& b) {
    fmpz_t e;
    fmpz_t f;
    fmpz_init(e);
    fmpz_init(f);
    arf_abs_bound_lt_2exp_fmpz(e, arb_midref(a.handle()));
    arf_abs_bound_lt_2exp_fmpz(f, arb_midref(b.handle()));
    fmpz_add(e, e, f);
    fmpz_sub_ui(e, e, 1);
    fmpz_fdiv_q_2exp(e, e, 1);
    ball result(1);
    arb_mul_2exp_fmpz(result.handle(), result.handle(), e);
    fmpz_clear(e);
    fmpz_clear(f);
    return result;
}

/// The midpoint as an exact ball.
inline ball midpoint_alone(const ball& x) {
    ball result;
    arf_set(arb_midref(result.handle()), arb_midref(x.handle()));
    return result;
}

/// The method narrows an enclosure of 0 itself indefinitely.
inline constexpr int most_newton_steps = 100;

/// Newton's method on balls: an enclosure of the zero of a function within a ball, if there is one, from enclosures of
/// its value and slope on balls inside it; the ball itself if its slope contains 0. Returns std::nullopt if the
/// function has no zero in the ball.
template <class Value, class Slope>
std::optional<ball> zero_within(ball place, const Value& value, const Slope& slope) {
    bool narrows = true;
    for (int step = 0; narrows && step < most_newton_steps; ++step) {
        const ball middle = midpoint_alone(place);
        const ball next = middle - value(middle) / slope(place);
        if (!is_finite(next)) {
            break;
        }
        ball narrower;
        if (arb_intersection(narrower.handle(), place.handle(), next.handle(), ball::working_bits()) == 0) {
            return std::nullopt;
        }
        narrows = magnitude::radius_of(narrower) < magnitude::radius_of(place) * magnitude::of(3, -2);
        place = std::move(narrower);
    }
    return place;
}

/// from and to are exact distances from the beginning of the step, 0 <= from < to.
struct step_piece {
    ball from, to;
    long digits = 0;      ///< the precision in which it is examined
    int halvings = 0;     ///< for a piece that begins at 0: the next one is by 2^-(2^halvings)
    int slope = 0;        ///< the sign of the derivative of a function known to be monotone on it
    bool beyond = false;  ///< it begins at the end of the requested interval, or after it

    bool at_0() const { return arb_is_zero(from.handle()) != 0; }
    /// An exact number between the ends: the middle of their exponents if they are far apart.
    ball middle() const {
        return at_0()                                         ? exact_multiple(to, 1, -(1L << halvings))
               : exactly_less(exact_multiple(from, 4, 0), to) ? power_between(from, to)
                                                              : exact_multiple(exact_sum(from, to), 1, -1);
    }
    /// Whether it is shorter than 2^-bits relative to its end or, if it begins at 0, the next cut is below 2^-(64
    /// bits).
    bool is_narrow(long bits) const {
        constexpr long most_bits_towards_0 = 64;
        return at_0() ? (1L << halvings) > most_bits_towards_0 * bits
                      : exactly_less(to, exact_sum(from, exact_multiple(to, 1, -bits)));
    }
    step_piece before(const ball& place) const { return {from, place, digits, at_0() ? halvings + 1 : 0, 0, beyond}; }
    step_piece behind(const ball& place) const { return {place, to, digits, 0, 0, beyond}; }
    /// Its intersection with an enclosure.
    step_piece within(const ball& place) const {
        step_piece part = *this;
        if (const ball least = lower_bound(place); exactly_less(from, least)) part = part.behind(least);
        if (const ball most = upper_bound(place); exactly_less(most, part.to)) part = part.before(most);
        return part;
    }
};

}  // namespace libration::ode
