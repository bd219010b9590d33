// Elliptic functions and integrals of exact arguments at an exact parameter, in balls: every limit and every exact
// value is decided on what was typed, and the rest is an enclosure.
//
// For 0 < m < 1 rational and u a rational multiple of 1 or pi other than 0, no value is 0 or at the end of its range: u
// would be a multiple of K, and K(m) and K(m)/pi are transcendental at algebraic m [Schneider]. So every digit of
// every value is found at some precision.
#pragma once

#include <stdexcept>
#include <utility>

#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// m = k^2 and 1 - m, exactly, 0 <= m <= 1.
class exact_parameter {
public:
    /// Each throws std::domain_error outside [0, 1], libration::error of kind undecided where no precision shows on
    /// which side of 0 or 1 a formula is.
    static exact_parameter from_modulus(const exact& k) { return from_parameter(checked(k) * k); }
    static exact_parameter from_parameter(const exact& m) { return {checked(m), exactly(1) - m}; }
    static exact_parameter from_complement(const exact& m1) { return {exactly(1) - m1, checked(m1)}; }
    static exact_parameter from_modulus(const rational& k) { return from_modulus(exactly(k)); }
    static exact_parameter from_parameter(const rational& m) { return from_parameter(exactly(m)); }
    static exact_parameter from_complement(const rational& m1) { return from_complement(exactly(m1)); }

    const exact& m() const { return m_; }
    const exact& complement() const { return complement_; }
    /// k and k', each to the working precision.
    modulus<ball> shape() const {
        return modulus<ball>::from_both(sqrt(from_exact<ball>(m_)), sqrt(from_exact<ball>(complement_)));
    }

private:
    exact_parameter(exact m, exact complement) : m_(std::move(m)), complement_(std::move(complement)) {}
    static const exact& checked(const exact& x) {
        if (sign_of_exact(x) < 0 || sign_of_exact(exactly(1) - x) < 0) {
            throw std::domain_error("is outside [0, 1]");
        }
        return x;
    }

    exact m_;
    exact complement_;
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
    if (u.is_angle()) {
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
    if (p.m().is_zero()) {
        return circular_value(f, u);
    }
    if (p.complement().is_zero()) {
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

/// The sign of the infinity that F(phi, m) is: 0 for m < 1 and for |phi| < pi/2. Decided exactly: a rational phi is not
/// pi/2. Throws libration::error of kind undecided where no precision tells a formula from pi/2.
inline int infinite_sign(const exact& phi, const exact_parameter& p) {
    if (!p.complement().is_zero()) {
        return 0;
    }
    const int sign = sign_of_exact(phi);
    const exact quarter_turn{rational(1, 2), unit::pi, "pi/2"};
    return sign_of_exact(sign < 0 ? quarter_turn + phi : quarter_turn - phi) > 0 ? 0 : sign;
}

/// F(phi, m) where it is finite, unwrapped; a multiple of K at multiples of pi/2, asinh tan phi at m = 1 [DLMF 19.6.8].
/// Throws std::domain_error where it is infinite.
inline ball incomplete_value(const exact& phi, const exact_parameter& p) {
    if (infinite_sign(phi, p) != 0) {
        throw std::domain_error("F(" + phi.text + ", 1) is infinite");
    }
    if (phi.is_zero() || p.m().is_zero()) {
        return from_exact<ball>(phi);
    }
    if (p.complement().is_zero()) {
        return asinh(tan(from_exact<ball>(phi)));
    }
    if (phi.is_angle()) {
        if (const rational quarters = phi.in_pi() * 2; denominator(quarters) == 1) {
            return complete_integral(p.shape()) * from_rational<ball>(quarters);
        }
    }
    return incomplete_integral(from_exact<ball>(phi), p.shape());
}

}  // namespace libration
