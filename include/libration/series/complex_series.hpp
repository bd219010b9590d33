// Complex numbers as pairs of any scalar, and power series with such coefficients. std::complex is specified for the
// built-in floating types alone.
#pragma once

#include <utility>

#include "libration/series/convolution.hpp"

namespace libration {

/// re + i im.
template <scalar T>
struct complex_pair {
    T re = T(0);
    T im = T(0);

    complex_pair operator+(const complex_pair& z) const { return {re + z.re, im + z.im}; }
    complex_pair operator-(const complex_pair& z) const { return {re - z.re, im - z.im}; }
    complex_pair operator*(const complex_pair& z) const { return {re * z.re - im * z.im, re * z.im + im * z.re}; }
    complex_pair operator*(const T& factor) const { return {re * factor, im * factor}; }
    complex_pair operator/(const T& divisor) const { return {re / divisor, im / divisor}; }
    complex_pair operator-() const { return {T(-re), T(-im)}; }
};

/// |z|. One square root; overflows and underflows with the square of z.
template <scalar T>
T magnitude(const complex_pair<T>& z) {
    using std::sqrt;
    return sqrt(z.re * z.re + z.im * z.im);
}

/// sum (re_n + i im_n) x^n. A series that is known to be real saves three of four products.
template <scalar T>
class complex_series {
public:
    complex_series(const complex_pair<T>& first, bool real)
        : re_(std::vector<T>{first.re}), im_(std::vector<T>{first.im}), real_(real) {}

    int order() const { return re_.order(); }
    complex_pair<T> operator[](int n) const { return {re_[n], im_[n]}; }
    void push_back(complex_pair<T> next) {
        re_.push_back(std::move(next.re));
        im_.push_back(std::move(next.im));
    }

    /// The coefficient of x^n in a b.
    friend complex_pair<T> product_coefficient(const complex_series& a, const complex_series& b, int n) {
        const T both_real = product_coefficient(a.re_, b.re_, n);
        if (a.real_ && b.real_) {
            return {both_real, T(0)};
        }
        return {both_real - product_coefficient(a.im_, b.im_, n),
                product_coefficient(a.re_, b.im_, n) + product_coefficient(a.im_, b.re_, n)};
    }

private:
    power_series<T> re_;
    power_series<T> im_;
    bool real_;
};

/// The value at z, by Horner's rule. O(N).
template <scalar T>
complex_pair<T> evaluate(const complex_series<T>& a, const complex_pair<T>& z) {
    complex_pair<T> value = a[a.order()];
    for (int n = a.order() - 1; n >= 0; --n) {
        value = value * z + a[n];
    }
    return value;
}

}  // namespace libration
