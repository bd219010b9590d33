// Numerical values of expressions: bounds rounded outwards at each step, by those functions of MPFR that are proved to
// round as requested [MPFR, algorithms.pdf]. Up to version 4.2.1 the error bounds used in mpfr_div (of mpfr_divhigh_n)
// and mpfr_pow (of mpfr_pow_general) are wrong: quotients are compared with their operands by an exact product,
// mpfr_set_q, which divides, by mpfr_cmp_q, which does not, and powers are roots of integer powers or exp(y log x).

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "exact_real_atom.hpp"
#include "libration/function/interval.hpp"
#include "libration/function/list.hpp"
#include "libration/number/exact_real.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

namespace {

using bounds = function::range;
using function::require_exponent;
using function::rising, function::quotient, function::size_of, function::at_corners, function::require_rounding;

// Numbers with more than this many bits before the point, or zeros after it, are rejected, since they become fractions.
constexpr long largest_exponent = 1L << 27U;

number_bounds of_fraction(const rational& q) {
    number_bounds result;
    mpfr_set_q(handle(result.lower), q.backend().data(), MPFR_RNDD);
    mpfr_set_q(handle(result.upper), q.backend().data(), MPFR_RNDU);
    require_rounding(mpfr_cmp_q(handle(result.lower), q.backend().data()) <= 0 &&
                     mpfr_cmp_q(handle(result.upper), q.backend().data()) >= 0);
    return result;
}

number_bounds of_pi() {
    number_bounds result;
    mpfr_const_pi(handle(result.lower), MPFR_RNDD);
    mpfr_const_pi(handle(result.upper), MPFR_RNDU);
    return result;
}

number_bounds sum(const number_bounds& a, const number_bounds& b) {
    number_bounds result;
    mpfr_add(handle(result.lower), handle(a.lower), handle(b.lower), MPFR_RNDD);
    mpfr_add(handle(result.upper), handle(a.upper), handle(b.upper), MPFR_RNDU);
    return result;
}

number_bounds product(const number_bounds& a, const number_bounds& b) { return at_corners(a, b, mpfr_mul); }

// x^n for n > 0.
number_bounds positive_power(const number_bounds& x, const integer& n) {
    const bool even = n % 2 == 0;
    const number_bounds from = even ? size_of(x) : x;
    number_bounds result;
    mpfr_pow_z(handle(result.lower), handle(from.lower), n.backend().data(), MPFR_RNDD);
    mpfr_pow_z(handle(result.upper), handle(from.upper), n.backend().data(), MPFR_RNDU);
    return result;
}

bounds whole_power(const number_bounds& x, const integer& n) {
    if (n == 0) {
        return of_fraction(1);
    }
    const number_bounds up = positive_power(x, abs(n));
    return n > 0 ? bounds(up) : quotient(of_fraction(1), up);
}

// The power with a fractional exponent n / 2^k, by square roots, which are exact if the results fit into this number of
// bits.
bounds root_of_power(const number_bounds& x, const integer& n, std::size_t k) {
    bounds result = whole_power(x, n);
    for (; result && k > 0; --k) {
        result = rising(mpfr_sqrt, *result);
    }
    return result;
}

bounds real_power(const number_bounds& x, const number_bounds& y, const std::optional<rational>& fraction) {
    constexpr std::size_t most_roots = 8;
    if (x.upper < 0) {
        refuse_number("raises a negative number to a non-integer power");
    }
    if (x.lower <= 0) {
        return std::nullopt;
    }
    if (fraction && msb(denominator(*fraction)) == lsb(denominator(*fraction)) &&
        msb(denominator(*fraction)) <= most_roots) {
        return root_of_power(x, numerator(*fraction), msb(denominator(*fraction)));
    }
    const number_bounds exponent = product(y, rising(mpfr_log, x));
    require_exponent(exponent);
    return rising(mpfr_exp, exponent);
}

bool is_in_range(const mpfr& x) {
    return mpfr_zero_p(handle(x)) != 0 ||
           (mpfr_number_p(handle(x)) != 0 && std::labs(mpfr_get_exp(handle(x))) <= largest_exponent);
}

bool is_narrow(const number_bounds& x, long bits) {
    if (x.lower <= 0 && x.upper >= 0) {
        return x.lower == 0 && x.upper == 0;
    }
    const mpfr width = x.upper - x.lower;
    const mpfr size = x.lower > 0 ? x.lower : mpfr(-x.upper);
    return width == 0 || binary_exponent(width) <= binary_exponent(size) - 2 - bits;
}

// Whether both ends are smaller than 2^exponent.
bool is_below(const number_bounds& x, long exponent) {
    const auto small = [&](const mpfr& end) { return end == 0 || binary_exponent(end) < exponent; };
    return small(x.lower) && small(x.upper);
}

}  // namespace

// One evaluation in the current precision: shared atoms are evaluated once.
class exact_real::evaluation {
public:
    bounds of(const exact_real& x) {
        number_bounds total{mpfr(0), mpfr(0)};
        for (const term& each : x.terms_) {
            const number_bounds factor = of_fraction(each.coefficient);
            if (each.of->kind == atom_kind::one) {
                total = sum(total, factor);
                continue;
            }
            const bounds value = of(*each.of);
            if (!value) {
                return std::nullopt;
            }
            total = sum(total, product(*value, factor));
        }
        if (!is_in_range(total.lower) || !is_in_range(total.upper)) {
            refuse_number("is beyond the range of numbers");
        }
        return total;
    }

private:
    static bounds of_function(const atom& a, const number_bounds& x) {
        return function::with_function(a.f, [&](auto of) -> bounds {
            using each = decltype(of);
            if constexpr (function::ordered<each>) {
                return each::bounds(a.right.fraction().value(), x);
            } else {
                return each::bounds(x);
            }
        });
    }

    bounds of(const atom& a) {
        switch (a.kind) {
            case atom_kind::pi: return of_pi();
            case atom_kind::degree: return product(of_pi(), of_fraction(rational(1, 180)));
            case atom_kind::period:
                throw error(error_kind::argument, error_subject::number, "", "is a multiple of a period, not a number");
            case atom_kind::one:
            case atom_kind::product:
            case atom_kind::quotient:
            case atom_kind::power:
            case atom_kind::function: break;
        }
        const auto known = done_.find(&a);
        return known != done_.end() ? known->second : done_.emplace(&a, composed(a)).first->second;
    }

    bounds composed(const atom& a) {
        const bounds left = of(a.left);
        if (!left || a.kind == atom_kind::function) {
            return left ? of_function(a, *left) : std::nullopt;
        }
        const bounds right = of(a.right);
        if (!right) {
            return std::nullopt;
        }
        if (a.kind == atom_kind::product) {
            return product(*left, *right);
        }
        if (a.kind == atom_kind::quotient) {
            return quotient(*left, *right);
        }
        const auto n = a.right.fraction();
        return n && denominator(*n) == 1 ? whole_power(*left, numerator(*n)) : real_power(*left, *right, n);
    }

    std::unordered_map<const atom*, bounds> done_;
};

std::optional<number_bounds> exact_real::bounds_at(long bits) const {
    const precision_scope scope(decimal_digits(bits));
    return evaluation().of(*this);
}

long exact_real::most_bits() const {
    constexpr long without_functions = 1L << 20U;
    constexpr long with_one = 1L << 18U;
    const long costly = functions();
    return costly == 0 ? without_functions : std::max(1L << 13U, with_one / costly);
}

number_bounds exact_real::narrowed(long bits) const {
    std::optional<long> exponent;
    for (long at = bits + 64;; at *= 2) {
        auto found = bounds_at(at);
        if (found && is_narrow(*found, bits)) {
            return *std::move(found);
        }
        if (found && found->lower <= 0 && found->upper >= 0) {
            exponent = exponent ? exponent : separation_exponent();
            if (exponent && is_below(*found, -*exponent)) {
                return {mpfr(0), mpfr(0)};
            }
        }
        if (at > std::max(most_bits(), 4 * bits)) {
            throw error(error_kind::undecided, error_subject::number, "",
                        "may be 0: no precision up to " + std::to_string(at) + " bits decides");
        }
    }
}

int exact_real::sign() const {
    if (const auto number = plain()) {
        return number->coefficient.sign();
    }
    const number_bounds within = narrowed(2);
    return within.lower > 0 ? 1 : within.upper < 0 ? -1 : 0;
}

mpfr rounded_value(const exact_real& x) {
    const number_bounds within = x.narrowed(static_cast<long>(mpfr_get_prec(handle(mpfr()))) + 66);
    mpfr result;
    mpfr_set(handle(result), handle(within.lower), MPFR_RNDN);
    return result;
}

}  // namespace libration
