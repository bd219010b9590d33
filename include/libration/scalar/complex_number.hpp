// A complex number as a pair of scalars: std::complex is only specified for the built-in floating types.
//
// Deliberately not a library type: Boost's complex_adaptor and mpc_complex round differently (mpc correctly, with an
// additional library), neither accepts a ball, FLINT's acb accepts nothing else, and all of them would have to be
// distinguished wherever time is complex; this is the textbook arithmetic on any scalar.
#pragma once

#include <concepts>
#include <utility>

#include "libration/scalar/inner_product.hpp"

namespace libration {

/// re + i im; each operation costs as much as the textbook formula, and products round in both of their terms, so that
/// a part that suffers from cancellation is accurate only relative to the whole number.
template <scalar T>
struct complex_number {
    T re = T(0);
    T im = T(0);

    complex_number() = default;
    complex_number(T real, T imaginary = T(0)) : re(std::move(real)), im(std::move(imaginary)) {}
    /// An integer, exactly.
    template <std::same_as<int> I>
    explicit complex_number(I n) : re(n) {}

    complex_number& operator+=(const complex_number& b) { return *this = *this + b; }
    complex_number& operator-=(const complex_number& b) { return *this = *this - b; }
    complex_number& operator*=(const complex_number& b) { return *this = *this * b; }
    complex_number& operator/=(const complex_number& b) { return *this = *this / b; }

    friend complex_number operator+(const complex_number& a, const complex_number& b) {
        return {T(a.re + b.re), T(a.im + b.im)};
    }
    friend complex_number operator-(const complex_number& a, const complex_number& b) {
        return {T(a.re - b.re), T(a.im - b.im)};
    }
    friend complex_number operator*(const complex_number& a, const complex_number& b) {
        return {T(a.re * b.re - a.im * b.im), T(a.re * b.im + a.im * b.re)};
    }
    friend complex_number operator-(const complex_number& a) { return {T(-a.re), T(-a.im)}; }
    friend complex_number operator*(const complex_number& a, const T& factor) {
        return {T(a.re * factor), T(a.im * factor)};
    }
    friend complex_number operator/(const complex_number& a, const T& divisor) {
        return {T(a.re / divisor), T(a.im / divisor)};
    }
    template <std::same_as<int> I>
    friend complex_number operator*(const complex_number& a, I n) {
        return {T(a.re * n), T(a.im * n)};
    }
    template <std::same_as<int> I>
    friend complex_number operator/(const complex_number& a, I n) {
        return {T(a.re / n), T(a.im / n)};
    }
    /// By the squared modulus of b, which must be in range and nonzero.
    friend complex_number operator/(const complex_number& a, const complex_number& b) {
        const T square = b.re * b.re + b.im * b.im;
        return {T((a.re * b.re + a.im * b.im) / square), T((a.im * b.re - a.re * b.im) / square)};
    }
    friend bool operator==(const complex_number& a, const complex_number& b) requires std::equality_comparable<T> {
        return a.re == b.re && a.im == b.im;
    }
};

/// Specialised operations of complex numbers: an inner product is computed as four real ones, by the method of T.
template <scalar T>
struct scalar_traits<complex_number<T>> {
    static complex_number<T> sum_of_products(const complex_number<T>* x, int x_step, const complex_number<T>* y,
                                             int y_step, int count) {
        static_assert(sizeof(complex_number<T>) == 2 * sizeof(T), "the parts alternate in memory");
        const auto sum = [&](const T& of_x, const T& of_y) { return of_parts(&of_x, x_step, &of_y, y_step, count); };
        return {T(sum(x->re, y->re) - sum(x->im, y->im)), T(sum(x->re, y->im) + sum(x->im, y->re))};
    }

private:
    // Steps count complex numbers.
    static T of_parts(const T* x, int x_step, const T* y, int y_step, int count) {
        if constexpr (std::same_as<T, double>) {
            if (x_step == 1 && y_step == -1) {
                return sum_in_lanes<2, -2>(x, y, count);
            }
        }
        return inner_product(x, 2 * x_step, y, 2 * y_step, count);
    }
};

/// |z|. The squares must be in range.
template <scalar T>
T modulus_of(const complex_number<T>& z) {
    using std::sqrt;
    return sqrt(T(z.re * z.re + z.im * z.im));
}

/// The root with real part >= 0: the larger of its parts from a sum, the other from the product 2 re im, so that
/// neither suffers from cancellation; +i sqrt(-re) for negative real numbers.
template <rounding_scalar T>
complex_number<T> square_root(const complex_number<T>& z) {
    using std::abs;
    using std::sqrt;
    if (z.re == 0 && z.im == 0) {
        return {T(0), T(0)};
    }
    const T larger = sqrt(T((modulus_of(z) + abs(z.re)) / 2));
    const T smaller = abs(z.im) / (larger * 2);
    const int sign = z.im < 0 ? -1 : 1;
    return z.re < 0 ? complex_number<T>{smaller, T(larger * sign)} : complex_number<T>{larger, T(smaller * sign)};
}

}  // namespace libration
