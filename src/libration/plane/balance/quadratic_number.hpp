// Numbers of a quadratic field, exactly.
#pragma once

#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/convert.hpp"

namespace libration::ode {

// p + q sqrt(radicand); rational numbers have q = 0 and any radicand. Operands with q != 0 have one radicand, not a square.
struct quadratic_number {
    rational p = 0, q = 0, radicand = 1;

    quadratic_number() = default;
    explicit quadratic_number(rational value) : p(std::move(value)) {}
    quadratic_number(rational a, rational b, rational d) : p(std::move(a)), q(std::move(b)), radicand(std::move(d)) {}

    bool is_zero() const { return p == 0 && q == 0; }
    bool is_rational() const { return q == 0; }
    bool is_integer() const { return is_rational() && denominator(p) == 1; }
    const rational& field_with(const quadratic_number& b) const { return q == 0 ? b.radicand : radicand; }

    friend quadratic_number operator+(const quadratic_number& a, const quadratic_number& b) {
        return {a.p + b.p, a.q + b.q, a.field_with(b)};
    }
    friend quadratic_number operator-(const quadratic_number& a, const quadratic_number& b) {
        return {a.p - b.p, a.q - b.q, a.field_with(b)};
    }
    friend quadratic_number operator*(const quadratic_number& a, const quadratic_number& b) {
        const rational& d = a.field_with(b);
        return {a.p * b.p + a.q * b.q * d, a.p * b.q + a.q * b.p, d};
    }
    friend quadratic_number operator/(const quadratic_number& a, const quadratic_number& b) {
        const rational norm = b.p * b.p - b.q * b.q * b.radicand;
        return a * quadratic_number(b.p / norm, -b.q / norm, b.radicand);
    }
    friend bool operator==(const quadratic_number& a, const quadratic_number& b) { return a.p == b.p && a.q == b.q; }

    double real_part() const {
        const double root = radicand > 0 && q != 0 ? std::sqrt(static_cast<double>(radicand)) : 0;
        return static_cast<double>(p) + static_cast<double>(q) * root;
    }
    complex_number<ball> value() const {
        const auto a = from_rational<ball>(p);
        if (q == 0) {
            return {a, ball(0)};
        }
        const ball root = from_rational<ball>(q) * sqrt(from_rational<ball>(rational(abs(radicand))));
        return radicand < 0 ? complex_number<ball>{a, root} : complex_number<ball>{ball(a + root), ball(0)};
    }
};

}  // namespace libration::ode
