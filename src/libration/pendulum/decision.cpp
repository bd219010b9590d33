#include "libration/pendulum/decision.hpp"

#include <algorithm>
#include <utility>

#include "libration/digits/precision_loop.hpp"

namespace libration::pendulum {

proved_sign decide_sign(const std::function<bounded_value()>& evaluate, const std::string& what) {
    constexpr long first = decimal_digits(128);
    return with_growing_precision({0, first, first << 13U}, "the sign of " + what,
                                  [&](const precision_run& /*run*/) -> std::optional<proved_sign> {
                                      const bounded_value at = evaluate();
                                      if (abs(at.value) > at.error * 2) {
                                          return proved_sign{mpfr_sgn(handle(at.value)), binary_exponent(at.value)};
                                      }
                                      return std::nullopt;
                                  });
}

proved_sign sign_of(const rational& q) {
    const precision_scope scope(20);
    return {q.sign(), binary_exponent(from_rational<mpfr>(q))};
}

proved_sign sign_of(const exact& number, const std::string& what) {
    if (number.measure != unit::expression) {
        const precision_scope scope(20);
        return {number.coefficient.sign(), binary_exponent(from_exact<mpfr>(number))};
    }
    try {
        const number_bounds within = number.formula->narrowed(8);
        return {within.lower > 0 ? 1 : within.upper < 0 ? -1 : 0, binary_exponent(within.lower)};
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        throw error(error_kind::undecided, "the sign of " + what, number.text,
                    "is not decided: it " + problem.reason());
    }
}

std::optional<rational> rational_cosine(const exact& angle) {
    if (angle.is_zero()) {
        return rational(1);
    }
    if (!angle.is_angle()) {
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

proved_sign sign_of_sum_with_cosine(const rational& a, const exact& angle, const std::string& what) {
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

namespace {

// The turns of a formula: the nearest integer to an approximation, if the rest is certainly between -pi and pi or not.
winding wind_formula(const exact& angle) {
    integer turns;
    {
        const long size = std::max(0L, sign_of(angle, "an angle").exponent);
        const precision_scope scope(decimal_digits(64 + size));
        turns = nearest_integer(from_exact<mpfr>(angle) / (pi<mpfr>() * 2));
    }
    const exact half_turn{1, unit::pi, "pi"};
    for (;;) {
        const exact rest = exactly(as_exact_real(angle) - exact_real(rational(turns * 2), unit::pi), angle.text);
        const proved_sign sign = sign_of(rest, angle.text + " modulo 2 pi");
        const std::string what = "pi less |" + angle.text + "| modulo 2 pi";
        if (sign_of(sign.sign < 0 ? half_turn + rest : half_turn - rest, what).sign >= 0) {
            return {turns, sign};
        }
        turns += sign.sign;
    }
}

}  // namespace

winding wind(const exact& angle) {
    if (angle.measure == unit::expression) {
        return wind_formula(angle);
    }
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

}  // namespace libration::pendulum
