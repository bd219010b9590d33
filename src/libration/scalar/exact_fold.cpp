#include "exact_fold.hpp"

#include <cstdlib>

#include "expression_atom.hpp"

namespace libration {

namespace {

constexpr long most_bits = 1'000'000;
constexpr long largest_root = 64;

long bits_of(const rational& q) {
    const auto size = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
    return std::max(size(mpq_numref(q.backend().data())), size(mpq_denref(q.backend().data())));
}

[[noreturn]] void refuse_range() { refuse_number("is beyond the range 1e-100000 .. 1e100000"); }

// The root of this order of a positive fraction, where it is a fraction.
std::optional<rational> exact_root(const rational& q, unsigned long order) {
    integer above;
    integer below;
    const bool exact = mpz_root(above.backend().data(), mpq_numref(q.backend().data()), order) != 0 &&
                       mpz_root(below.backend().data(), mpq_denref(q.backend().data()), order) != 0;
    return exact ? std::optional(rational(above, below)) : std::nullopt;
}

// q less its whole part, in [0, 1).
rational part_of_one(const rational& q) {
    integer floor;
    mpz_fdiv_q(floor.backend().data(), mpq_numref(q.backend().data()), mpq_denref(q.backend().data()));
    return q - rational(floor);
}

// cos(q pi) for q in [0, 2), where it is rational.
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

std::optional<rational> cosine(const rational& in_pi) { return cosine_of_turn(part_of_one(in_pi / 2) * 2); }

std::optional<rational> tangent(const rational& in_pi) {
    const rational quarters = part_of_one(in_pi) * 4;
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

// acos(x) in multiples of pi.
std::optional<rational> arccosine(const rational& x) {
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

std::optional<rational> square_root(const rational& x) {
    if (x < 0) {
        refuse_number("takes the root of a negative number");
    }
    return exact_root(x, 2);
}

std::optional<plain_number> in(unit measure, const std::optional<rational>& q) {
    return q ? std::optional(plain_number{*q, *q == 0 ? unit::one : measure}) : std::nullopt;
}

std::optional<plain_number> folded_at_fraction(elementary f, const rational& x) {
    const auto value_at_zero = [&](int value) { return x == 0 ? std::optional(rational(value)) : std::nullopt; };
    switch (f) {
        case elementary::exp:
        case elementary::cos:
        case elementary::cosh: return in(unit::one, value_at_zero(1));
        case elementary::log:
            if (x <= 0) {
                refuse_number("takes the logarithm of a number that is not positive");
            }
            return x == 1 ? in(unit::one, rational(0)) : std::nullopt;
        case elementary::sqrt: return in(unit::one, square_root(x));
        case elementary::acos: return in(unit::pi, arccosine(x));
        case elementary::asin: {
            const auto complement = arccosine(x);
            return complement ? in(unit::pi, rational(rational(1, 2) - *complement)) : std::nullopt;
        }
        case elementary::atan: return abs(x) == 1 ? in(unit::pi, rational(x / 4)) : in(unit::one, value_at_zero(0));
        case elementary::sin:
        case elementary::tan:
        case elementary::sinh:
        case elementary::tanh: break;
    }
    return in(unit::one, value_at_zero(0));
}

}  // namespace

rational within_limits(rational q) {
    if (bits_of(q) > most_bits) {
        refuse_range();
    }
    return q;
}

std::optional<rational> folded_power(const rational& base, const rational& exponent) {
    const integer order = denominator(exponent);
    rational root = base;
    if (order != 1) {
        if (base < 0) {
            refuse_number("raises a negative number to a power that is not whole");
        }
        const auto found = order > largest_root ? std::nullopt : exact_root(base, order.convert_to<unsigned long>());
        if (!found) {
            return std::nullopt;
        }
        root = *found;
    }
    if (root == 0 || root == 1) {
        return root;
    }
    const integer times = abs(numerator(exponent));
    if (times > most_bits || times * bits_of(root) > 2 * most_bits) {
        if (root == -1) {
            return rational(times % 2 == 0 ? 1 : -1);
        }
        refuse_range();
    }
    const auto n = times.convert_to<unsigned>();
    const integer above = boost::multiprecision::pow(numerator(root), n);
    const integer below = boost::multiprecision::pow(denominator(root), n);
    return within_limits(exponent < 0 ? rational(rational(below) / rational(above)) : rational(above, below));
}

std::optional<plain_number> folded_function(elementary f, const plain_number& x) {
    if (x.measure == unit::one) {
        return folded_at_fraction(f, x.coefficient);
    }
    const rational in_pi = x.measure == unit::degree ? rational(x.coefficient / 180) : x.coefficient;
    switch (f) {
        case elementary::cos: return in(unit::one, cosine(in_pi));
        case elementary::sin: return in(unit::one, cosine(rational(in_pi - rational(1, 2))));
        case elementary::tan: return in(unit::one, tangent(in_pi));
        case elementary::exp:
        case elementary::log:
        case elementary::sqrt:
        case elementary::asin:
        case elementary::acos:
        case elementary::atan:
        case elementary::sinh:
        case elementary::cosh:
        case elementary::tanh: break;
    }
    return std::nullopt;
}

}  // namespace libration
