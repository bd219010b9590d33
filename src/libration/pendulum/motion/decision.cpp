#include "libration/pendulum/motion/decision.hpp"

#include <utility>

#include "libration/digits/growing_precision.hpp"

namespace libration {

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

std::optional<rational> rational_cosine(const exact& angle) {
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

integer nearest_integer(const rational& q) {
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

winding wind(const exact& angle) {
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
