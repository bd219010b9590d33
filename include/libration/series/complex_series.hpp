// Power series with complex coefficients.
#pragma once

#include <utility>

#include "libration/scalar/complex_number.hpp"
#include "libration/series/convolution.hpp"

namespace libration {

/// sum (re_n + i im_n) x^n. A series that is known to be real saves three of four products.
template <scalar T>
class complex_series {
public:
    complex_series(const complex_number<T>& first, bool real)
        : re_(std::vector<T>{first.re}), im_(std::vector<T>{first.im}), real_(real) {}

    int order() const { return re_.order(); }
    complex_number<T> operator[](int n) const { return {re_[n], im_[n]}; }
    void push_back(complex_number<T> next) {
        re_.push_back(std::move(next.re));
        im_.push_back(std::move(next.im));
    }

    /// The coefficient of x^n in a b.
    friend complex_number<T> product_coefficient(const complex_series& a, const complex_series& b, int n) {
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
complex_number<T> evaluate(const complex_series<T>& a, const complex_number<T>& z) {
    complex_number<T> value = a[a.order()];
    for (int n = a.order() - 1; n >= 0; --n) {
        value = value * z + a[n];
    }
    return value;
}

}  // namespace libration
