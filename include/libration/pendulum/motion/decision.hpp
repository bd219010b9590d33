// Exact decisions about typed numbers: signs by outward-rounded comparison at doubling precision, after the exact ties
// have been taken out (Niven: cos(q pi) is rational only for q in Z/2 or Z/3; Lindemann: cos of a rational other than 0
// is transcendental). No tolerance decides anything.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "libration/scalar/concept.hpp"

namespace libration {

/// A proved sign, with the e of 2^(e-1) <= |value| < 2^(e+1).
struct proved_sign {
    int sign = 0;
    long exponent = exponent_of_zero;
};

/// A value computed at the working precision with a bound of its error.
struct bounded_value {
    mpfr value;
    mpfr error;
};

/// The sign of a real number known not to be 0: evaluate() is called at 128, 256, ... bits until its value exceeds
/// twice its error bound. Throws std::domain_error when a million bits do not decide.
template <class F>
proved_sign decide_sign(const F& evaluate, const std::string& what) {
    for (long bits = 128; bits <= (1L << 20); bits *= 2) {
        const precision_scope scope(decimal_digits(bits));
        const bounded_value at = evaluate();
        if (abs(at.value) > at.error * 2) {
            return {mpfr_sgn(handle(at.value)), binary_exponent(at.value)};
        }
    }
    throw std::domain_error("the sign of " + what + " is not decided by a million bits");
}

/// The sign of an exact fraction.
inline proved_sign sign_of(const rational& q) {
    const precision_scope scope(20);
    return {q.sign(), binary_exponent(from_rational<mpfr>(q))};
}

/// cos of the angle where it is rational: angles 0 and multiples of pi/2 and pi/3.
inline std::optional<rational> rational_cosine(const exact& angle) {
    if (angle.is_zero()) {
        return rational(1);
    }
    if (angle.measure == unit::one) {
        return std::nullopt;
    }
    const rational q = angle.in_pi();
    const integer below = denominator(q);
    if (below > 3) {
        return std::nullopt;
    }
    const integer above = numerator(q);
    const bool even = above % 2 == 0;
    if (below == 1) {
        return rational(even ? 1 : -1);
    }
    if (below == 2) {
        return rational(0);
    }
    return rational(even ? -1 : 1, 2);
}

/// The sign of a + cos(angle): exact where the cosine is rational, proved otherwise.
/// Error: half an ulp of the angle, of the cosine, of a and of the sum, at most 2^-p (|angle| + 2 + 2|a|).
inline proved_sign sign_of_sum_with_cosine(const rational& a, const exact& angle, const std::string& what) {
    if (const auto cosine = rational_cosine(angle)) {
        return sign_of(rational(a + *cosine));
    }
    return decide_sign(
        [&] {
            const mpfr x = from_exact<mpfr>(angle);
            const mpfr rest = from_rational<mpfr>(a);
            return bounded_value{cos(x) + rest, epsilon<mpfr>() * (abs(x) + 2 + abs(rest) * 2)};
        },
        what);
}

/// An angle as 2 pi turns + rest with rest in [-pi, pi]: the turns, and the sign and size of the rest.
struct winding {
    integer turns;
    proved_sign rest;
};

/// The integer nearest to q, ties to even.
inline integer nearest_integer(const rational& q) {
    const rational twice = q * 2;
    integer floor_of_twice = numerator(twice) / denominator(twice);
    if (twice < 0 && rational(floor_of_twice) != twice) {
        --floor_of_twice;
    }
    // q in [f/2, (f+1)/2): nearest is f/2 for even f, (f+1)/2 for odd f above the tie; a tie is an odd exact 2q.
    if (floor_of_twice % 2 == 0) {
        return floor_of_twice / 2;
    }
    const integer above = (floor_of_twice + 1) / 2;
    const bool tie = rational(floor_of_twice) == twice;
    return tie && above % 2 != 0 ? integer(above - 1) : above;
}

/// Turns and rest of an angle; a multiple of pi that is odd has its rest at +pi or -pi.
inline winding wind(const exact& angle) {
    if (angle.measure != unit::one || angle.is_zero()) {
        const rational half_turns = angle.in_pi();
        const integer turns = nearest_integer(rational(half_turns / 2));
        return {turns, sign_of(rational(half_turns - rational(turns) * 2))};
    }
    integer turns;
    // Near an odd multiple of pi the turns are not decided until the distance to it is.
    decide_sign(
        [&] {
            const mpfr x = from_exact<mpfr>(angle) / (pi<mpfr>() * 2);
            turns = nearest_integer(x);
            const mpfr to_tie = mpfr(1) / 2 - abs(x - from_rational<mpfr>(rational(turns)));
            return bounded_value{to_tie, epsilon<mpfr>() * (abs(x) * 3 + 2)};
        },
        "the turns of " + angle.text);
    const proved_sign rest = decide_sign(
        [&] {
            const mpfr x = from_exact<mpfr>(angle);
            const mpfr whole = pi<mpfr>() * from_rational<mpfr>(rational(turns)) * 2;
            return bounded_value{x - whole, epsilon<mpfr>() * (abs(x) + abs(whole) * 3)};
        },
        angle.text + " modulo 2 pi");
    return {turns, rest};
}

}  // namespace libration
