// Elliptic functions and integrals of exact arguments at an exact parameter: every limit and every exact value is
// decided from the input as given, and the rest is computed in T, rounded or enclosed.
//
// For 0 < m < 1 rational and u a nonzero rational multiple of 1 or pi, no value is 0 or at the end of its range: u
// would be a multiple of K, and K(m) and K(m)/pi are transcendental at algebraic m [Schneider]. Every digit of every
// value is therefore found at some precision.
#pragma once

#include <utility>

#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"

namespace libration::elliptic {

/// m = k^2 and 1 - m, exactly, 0 <= m <= 1.
class exact_parameter {
public:
    /// Each throws error of the kind argument outside [0, 1], of the kind undecided if no precision determines on which
    /// side of 0 or 1 a formula is.
    static exact_parameter from_modulus(const exact& k) { return from_parameter(checked("modulus", k) * k); }
    static exact_parameter from_parameter(const exact& m) { return {checked("parameter", m), exactly(1) - m}; }
    static exact_parameter from_complement(const exact& m1) {
        return {exactly(1) - m1, checked("complementary parameter", m1)};
    }
    static exact_parameter from_modulus(const rational& k) { return from_modulus(exactly(k)); }
    static exact_parameter from_parameter(const rational& m) { return from_parameter(exactly(m)); }
    static exact_parameter from_complement(const rational& m1) { return from_complement(exactly(m1)); }

    const exact& m() const { return m_; }
    const exact& complement() const { return complement_; }
    /// k and k', each to the working precision.
    template <scalar T>
    modulus<T> shape() const {
        using std::sqrt;
        return modulus<T>::from_both(sqrt(from_exact<T>(m_)), sqrt(from_exact<T>(complement_)));
    }

private:
    exact_parameter(exact m, exact complement) : m_(std::move(m)), complement_(std::move(complement)) {}
    static const exact& checked(const char* name, const exact& x) {
        if (sign_of_exact(x) < 0 || sign_of_exact(exactly(1) - x) < 0) {
            throw error(error_kind::argument, name, x.text, "is outside [0, 1]");
        }
        return x;
    }

    exact m_;
    exact complement_;
};

/// The functions computed by jacobi_value.
enum class jacobi_function { am, sn, cn, dn };

/// am, sn, cn and dn at m = 0: u, sin u, cos u and 1, exact if they are rational.
template <scalar T>
T circular_value(jacobi_function f, const exact& u) {
    using std::cos;
    using std::sin;
    switch (f) {
        case jacobi_function::am: return from_exact<T>(u);
        case jacobi_function::dn: return T(1);
        case jacobi_function::sn:
        case jacobi_function::cn: break;
    }
    if (u.is_angle()) {
        // sin q pi = cos (q - 1/2) pi, and the cosine of a whole number of quarter turns is 1, 0, -1 or 0.
        const rational q = f == jacobi_function::sn ? rational(u.in_pi() - rational(1, 2)) : u.in_pi();
        if (const rational quarters = q * 2; denominator(quarters) == 1) {
            const int quarter = quarter_of_four(numerator(quarters));
            return T(quarter % 2 != 0 ? 0 : 1 - quarter);
        }
    }
    const T x = from_exact<T>(u);
    return f == jacobi_function::sn ? sin(x) : cos(x);
}

/// am, sn, cn and dn at m = 1: gd u = 2 atan tanh(u/2), tanh u, 1/cosh u twice [DLMF 22.5(ii)].
template <scalar T>
T hyperbolic_value(jacobi_function f, const exact& u) {
    using std::atan;
    using std::cosh;
    using std::tanh;
    const T x = from_exact<T>(u);
    switch (f) {
        case jacobi_function::am: return atan(tanh(x / 2)) * 2;
        case jacobi_function::sn: return tanh(x);
        case jacobi_function::cn:
        case jacobi_function::dn: break;
    }
    return 1 / cosh(x);
}

/// The function at u. Cost O(log digits) square roots and divisions and a tangent; loses the bits that u has before its
/// point and log2(1/k') of them near odd multiples of K. On balls throws precision_exhausted if the quarter is not
/// decided.
template <scalar T>
T jacobi_value(jacobi_function f, const exact& u, const exact_parameter& p) {
    if (p.m().is_zero()) {
        return circular_value<T>(f, u);
    }
    if (p.complement().is_zero()) {
        return hyperbolic_value<T>(f, u);
    }
    if (u.is_zero()) {
        return T(f == jacobi_function::am || f == jacobi_function::sn ? 0 : 1);
    }
    const T x = from_exact<T>(u);
    if (f == jacobi_function::am) {
        return amplitude(x, p.shape<T>());
    }
    const auto values = jacobi(x, p.shape<T>());
    return f == jacobi_function::sn ? values.sn : f == jacobi_function::cn ? values.cn : values.dn;
}

/// The sign of F(phi, m) if it is infinite: 0 for m < 1 and for |phi| < pi/2. Decided exactly: a rational phi is not
/// pi/2. Throws error of the kind undecided if no precision distinguishes phi from pi/2.
int infinite_sign(const exact& phi, const exact_parameter& p);

/// F(phi, m) if finite, unwrapped; a multiple of K at multiples of pi/2, asinh tan phi at m = 1 [DLMF 19.6.8]. Throws
/// error of the kind argument if it is infinite.
template <scalar T>
T incomplete_value(const exact& phi, const exact_parameter& p) {
    using std::asinh;
    using std::tan;
    if (infinite_sign(phi, p) != 0) {
        throw error(error_kind::argument, "amplitude", phi.text, "makes F(phi, 1) infinite");
    }
    if (phi.is_zero() || p.m().is_zero()) {
        return from_exact<T>(phi);
    }
    if (p.complement().is_zero()) {
        return asinh(tan(from_exact<T>(phi)));
    }
    if (phi.is_angle()) {
        if (const rational quarters = phi.in_pi() * 2; denominator(quarters) == 1) {
            return complete_integral(p.shape<T>()) * from_rational<T>(quarters);
        }
    }
    return incomplete_integral(from_exact<T>(phi), p.shape<T>());
}

/// The number of decimal digits before its point, which an argument loses on reduction.
long digits_before_point(const exact& argument);

}  // namespace libration::elliptic
