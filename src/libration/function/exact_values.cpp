#include "libration/function/exact_values.hpp"

#include "libration/scalar/error.hpp"

namespace libration::function {

namespace {

// The fractional part of q, in [0, 1).
rational part_of_one(const rational& q) { return q - rational(floor_of(q)); }

// cos(q pi) for q in [0, 2), if it is rational.
std::optional<rational> cosine_of_turn(const rational& q) {
    const rational from_top = q > 1 ? rational(2 - q) : q;
    const rational sixths = from_top * 6;
    if (sixths == 0 || sixths == 6) {
        return rational(sixths == 0 ? 1 : -1);
    }
    if (sixths == 2 || sixths == 4) {
        return rational(sixths == 2 ? 1 : -1) / 2;
    }
    return sixths == 3 ? std::optional(rational(0)) : std::nullopt;
}

exact_value in(unit measure, const std::optional<rational>& q) {
    return q ? std::optional(plain_number{*q, *q == 0 ? unit::one : measure}) : std::nullopt;
}

}  // namespace

integer floor_of(const rational& q) {
    integer floor;
    mpz_fdiv_q(floor.backend().data(), mpq_numref(q.backend().data()), mpq_denref(q.backend().data()));
    return floor;
}

std::optional<rational> fraction_of(const plain_number& x) {
    return x.measure == unit::one ? std::optional(x.coefficient) : std::nullopt;
}

std::optional<rational> times_pi(const plain_number& x) {
    if (x.measure == unit::one) {
        return std::nullopt;
    }
    return x.measure == unit::degree ? rational(x.coefficient / 180) : x.coefficient;
}

exact_value ones(const std::optional<rational>& q) { return in(unit::one, q); }

exact_value of_pi(const std::optional<rational>& q) { return in(unit::pi, q); }

exact_value at_zero(const plain_number& x, int value) {
    return x.coefficient == 0 ? ones(rational(value)) : std::nullopt;
}

std::optional<rational> exact_root(const rational& q, unsigned long order) {
    integer above;
    integer below;
    const bool exact = mpz_root(above.backend().data(), mpq_numref(q.backend().data()), order) != 0 &&
                       mpz_root(below.backend().data(), mpq_denref(q.backend().data()), order) != 0;
    return exact ? std::optional(rational(above, below)) : std::nullopt;
}

std::optional<rational> exact_logarithm(const rational& q, int base) {
    const bool inverse = q < 1;
    const integer power = inverse ? denominator(q) : numerator(q);
    if ((inverse ? numerator(q) : denominator(q)) != 1) {
        return std::nullopt;
    }
    integer rest;
    const integer divisor(base);
    const auto times = mpz_remove(rest.backend().data(), power.backend().data(), divisor.backend().data());
    const rational found(times);
    return rest == 1 ? std::optional(inverse ? rational(-found) : found) : std::nullopt;
}

std::optional<rational> exact_cosine(const rational& times_pi) {
    return cosine_of_turn(rational(part_of_one(times_pi / 2) * 2));
}

std::optional<rational> exact_tangent(const rational& times_pi) {
    const rational quarters = part_of_one(times_pi) * 4;
    if (quarters == 2) {
        refuse_number("takes tan at a pole");
    }
    if (quarters == 0) {
        return rational(0);
    }
    if (quarters == 1 || quarters == 3) {
        return rational(quarters == 1 ? 1 : -1);
    }
    return std::nullopt;
}

std::optional<rational> exact_arccosine(const rational& x) {
    if (abs(x) > 1) {
        refuse_number("takes acos or asin of a number beyond 1");
    }
    for (int sixths = 0; sixths <= 6; ++sixths) {
        if (cosine_of_turn(rational(sixths, 6)) == x) {
            return rational(sixths, 6);
        }
    }
    return std::nullopt;
}

bool is_whole(const rational& q) { return denominator(q) == 1; }

bool is_first_of_pair(const rational& order) { return floor_of(order) % 2 == 0; }

}  // namespace libration::function
