// A complex number as a pair of scalars: std::complex is only specified for the built-in floating types.
#pragma once

#include "libration/scalar/concept.hpp"

namespace libration {

/// re + i im; each operation costs what the textbook formula does, and products round in both of their terms, so that a
/// part that cancels is right only relative to the whole number.
template <scalar T>
struct complex_number {
    T re = T(0);
    T im = T(0);

    friend complex_number operator+(const complex_number& a, const complex_number& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend complex_number operator-(const complex_number& a, const complex_number& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend complex_number operator*(const complex_number& a, const complex_number& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend complex_number operator-(const complex_number& a) { return {T(-a.re), T(-a.im)}; }
    friend complex_number operator*(const complex_number& a, const T& factor) { return {a.re * factor, a.im * factor}; }
    friend complex_number operator/(const complex_number& a, const T& divisor) {
        return {a.re / divisor, a.im / divisor};
    }
    /// By the squared modulus of b, which must be in range and not 0.
    friend complex_number operator/(const complex_number& a, const complex_number& b) {
        const T square = b.re * b.re + b.im * b.im;
        return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
    }
};

/// |z|. The squares have to be in range.
template <scalar T>
T modulus_of(const complex_number<T>& z) {
    using std::sqrt;
    return sqrt(z.re * z.re + z.im * z.im);
}

/// The root with real part >= 0: the larger of its parts as a sum, the other from the product 2 re im, so that neither
/// cancels; +i sqrt(-re) for negative real numbers.
template <rounding_scalar T>
complex_number<T> square_root(const complex_number<T>& z) {
    using std::abs;
    using std::sqrt;
    if (z.re == 0 && z.im == 0) {
        return {T(0), T(0)};
    }
    const T larger = sqrt((modulus_of(z) + abs(z.re)) / 2);
    const T smaller = abs(z.im) / (larger * 2);
    const int sign = z.im < 0 ? -1 : 1;
    return z.re < 0 ? complex_number<T>{smaller, larger * sign} : complex_number<T>{larger, smaller * sign};
}

}  // namespace libration
