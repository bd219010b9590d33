// The elementary functions of complex numbers, found by unqualified calls as for every scalar: principal values, by the
// formulas of [DLMF 4.2, 4.21, 4.28] from the real functions of the parts. A part that suffers from cancellation is
// accurate only relative to the whole number; if two terms of the size of |z| cancel as a whole, near the zeros of log,
// tan and atan, so is the result.
#pragma once

#include <cmath>

#include "libration/scalar/complex_number.hpp"

namespace libration {

/// e^x (cos y + i sin y).
template <scalar T>
complex_number<T> exp(const complex_number<T>& z) {
    using std::cos;
    using std::exp;
    using std::sin;
    const T size = exp(z.re);
    return {T(size * cos(z.im)), T(size * sin(z.im))};
}

/// log |z| + i arg z, -pi < arg z <= pi; z nonzero.
template <scalar T>
complex_number<T> log(const complex_number<T>& z) {
    using std::atan2;
    using std::log;
    return {T(log(modulus_of(z))), T(atan2(z.im, z.re))};
}

/// sin x cosh y + i cos x sinh y.
template <scalar T>
complex_number<T> sin(const complex_number<T>& z) {
    using std::cos, std::cosh, std::sin, std::sinh;
    return {T(sin(z.re) * cosh(z.im)), T(cos(z.re) * sinh(z.im))};
}

/// cos x cosh y - i sin x sinh y.
template <scalar T>
complex_number<T> cos(const complex_number<T>& z) {
    using std::cos, std::cosh, std::sin, std::sinh;
    return {T(cos(z.re) * cosh(z.im)), T(-sin(z.re) * sinh(z.im))};
}

/// sin z / cos z; cos z nonzero.
template <scalar T>
complex_number<T> tan(const complex_number<T>& z) {
    return sin(z) / cos(z);
}

/// -i tan(iz); cosh z nonzero.
template <scalar T>
complex_number<T> tanh(const complex_number<T>& z) {
    const complex_number<T> turned = tan(complex_number<T>{T(-z.im), z.re});
    return {turned.im, T(-turned.re)};
}

/// sinh x cos y + i cosh x sin y.
template <scalar T>
complex_number<T> sinh(const complex_number<T>& z) {
    using std::cos, std::cosh, std::sin, std::sinh;
    return {T(sinh(z.re) * cos(z.im)), T(cosh(z.re) * sin(z.im))};
}

/// cosh x cos y + i sinh x sin y.
template <scalar T>
complex_number<T> cosh(const complex_number<T>& z) {
    using std::cos, std::cosh, std::sin, std::sinh;
    return {T(cosh(z.re) * cos(z.im)), T(sinh(z.re) * sin(z.im))};
}

/// (i/2) (log(1 - iz) - log(1 + iz)); z not i or -i.
template <scalar T>
complex_number<T> atan(const complex_number<T>& z) {
    const complex_number<T> one(1);
    const complex_number<T> turned{T(-z.im), z.re};
    const complex_number<T> difference = log(one - turned) - log(one + turned);
    return {T(-difference.im / 2), T(difference.re / 2)};
}

/// The root with real part >= 0.
template <rounding_scalar T>
complex_number<T> sqrt(const complex_number<T>& z) {
    return square_root(z);
}

/// -i log(iz + sqrt(1 - z^2)).
template <rounding_scalar T>
complex_number<T> asin(const complex_number<T>& z) {
    const complex_number<T> turned{T(-z.im), z.re};
    const complex_number<T> logarithm = log(turned + sqrt(complex_number<T>(1) - z * z));
    return {logarithm.im, T(-logarithm.re)};
}

/// exp(w log z); z nonzero.
template <scalar T>
complex_number<T> pow(const complex_number<T>& z, const complex_number<T>& w) {
    return exp(w * log(z));
}

}  // namespace libration
