// Elliptic functions and integrals of exact arguments at an exact parameter, in balls: every limit and every exact
// value is decided on what was typed, and the rest is an enclosure.
//
// For 0 < m < 1 rational and u a rational multiple of 1 or pi other than 0, no value is 0 or at the end of its range: u
// would be a multiple of K, and K(m) and K(m)/pi are transcendental at algebraic m [Schneider]. So every digit of
// every value is found at some precision.
#pragma once

#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/digits/growing_precision.hpp"
#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// m = k^2 and 1 - m, exactly, 0 <= m <= 1.
class exact_parameter {
public:
    /// Each throws std::domain_error outside [0, 1].
    static exact_parameter from_modulus(const rational& k) { return from_parameter(checked(k) * k); }
    static exact_parameter from_parameter(const rational& m) { return {checked(m), rational(1 - m)}; }
    static exact_parameter from_complement(const rational& m1) { return {rational(1 - m1), checked(m1)}; }

    const rational& m() const { return m_; }
    const rational& complement() const { return complement_; }
    /// k and k', each to the working precision.
    modulus<ball> shape() const {
        return modulus<ball>::from_both(sqrt(from_rational<ball>(m_)), sqrt(from_rational<ball>(complement_)));
    }

private:
    exact_parameter(rational m, rational complement) : m_(std::move(m)), complement_(std::move(complement)) {}
    static const rational& checked(const rational& x) {
        if (x < 0 || x > 1) {
            throw std::domain_error("is outside [0, 1]");
        }
        return x;
    }

    rational m_;
    rational complement_;
};

/// What jacobi_value gives.
enum class jacobi_function { am, sn, cn, dn };

/// am, sn, cn and dn at m = 0: u, sin u, cos u and 1, exact where they are rational.
inline ball circular_value(jacobi_function f, const exact& u) {
    switch (f) {
        case jacobi_function::am: return from_exact<ball>(u);
        case jacobi_function::dn: return ball(1);
        default: break;
    }
    if (u.measure != unit::one) {
        // sin q pi = cos (q - 1/2) pi, and the cosine of a whole number of quarter turns is 1, 0, -1 or 0.
        const rational q = f == jacobi_function::sn ? rational(u.in_pi() - rational(1, 2)) : u.in_pi();
        if (const rational quarters = q * 2; denominator(quarters) == 1) {
            const int quarter = quarter_of_four(numerator(quarters));
            return ball(quarter % 2 != 0 ? 0 : 1 - quarter);
        }
    }
    const ball x = from_exact<ball>(u);
    return f == jacobi_function::sn ? sin(x) : cos(x);
}

/// am, sn, cn and dn at m = 1: gd u = 2 atan tanh(u/2), tanh u, 1/cosh u twice [DLMF 22.5(ii)].
inline ball hyperbolic_value(jacobi_function f, const exact& u) {
    const ball x = from_exact<ball>(u);
    switch (f) {
        case jacobi_function::am: return atan(tanh(x / 2)) * 2;
        case jacobi_function::sn: return tanh(x);
        default: return 1 / cosh(x);
    }
}

/// The function at u. Cost O(log digits) square roots and divisions and a tangent; loses the bits that u has before its
/// point and log2(1/k') of them next to odd multiples of K. Throws precision_exhausted where the quarter is not
/// decided.
inline ball jacobi_value(jacobi_function f, const exact& u, const exact_parameter& p) {
    if (p.m() == 0) {
        return circular_value(f, u);
    }
    if (p.complement() == 0) {
        return hyperbolic_value(f, u);
    }
    if (u.is_zero()) {
        return ball(f == jacobi_function::am || f == jacobi_function::sn ? 0 : 1);
    }
    const ball x = from_exact<ball>(u);
    if (f == jacobi_function::am) {
        return amplitude(x, p.shape());
    }
    const auto values = jacobi(x, p.shape());
    return f == jacobi_function::sn ? values.sn : f == jacobi_function::cn ? values.cn : values.dn;
}

/// Beyond the digits that a number can be typed with.
inline constexpr long most_digits_typed = 500'000;

/// The sign of the infinity that F(phi, m) is: 0 for m < 1 and for |phi| < pi/2. Decided exactly: a rational phi is not
/// pi/2. Throws error of the kind undecided where phi agrees with pi/2 to half a million digits.
inline int infinite_sign(const exact& phi, const exact_parameter& p) {
    const int sign = phi.coefficient.sign();
    if (p.complement() != 0) {
        return 0;
    }
    if (phi.measure != unit::one) {
        return abs(phi.in_pi()) < rational(1, 2) ? 0 : sign;
    }
    return with_growing_precision({0, 50, most_digits_typed}, "whether " + phi.text + " is below pi/2",
                                  [&](const precision_run& /*run*/) -> std::optional<int> {
                                      const ball rest = abs(from_exact<ball>(phi)) - pi<ball>() / 2;
                                      return decided_sign(rest) < 0 ? 0 : sign;
                                  });
}

/// F(phi, m) where it is finite, unwrapped; a multiple of K at multiples of pi/2, asinh tan phi at m = 1 [DLMF 19.6.8].
/// Throws std::domain_error where it is infinite.
inline ball incomplete_value(const exact& phi, const exact_parameter& p) {
    if (infinite_sign(phi, p) != 0) {
        throw std::domain_error("F(" + phi.text + ", 1) is infinite");
    }
    if (phi.is_zero() || p.m() == 0) {
        return from_exact<ball>(phi);
    }
    if (p.complement() == 0) {
        return asinh(tan(from_exact<ball>(phi)));
    }
    if (const rational quarters = phi.in_pi() * 2; phi.measure != unit::one && denominator(quarters) == 1) {
        return complete_integral(p.shape()) * from_rational<ball>(quarters);
    }
    return incomplete_integral(from_exact<ball>(phi), p.shape());
}

}  // namespace libration
