// Sum, product, quotient, derivative and integral of truncated power series, and their evaluation.
// A result has the smaller order of its operands: higher coefficients are unknown.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "libration/series/convolution.hpp"
#include "libration/series/jet.hpp"
#include "libration/series/polynomial_blocks.hpp"

namespace libration::series {

/// a + b. O(N).
template <ring T>
power_series<T> operator+(const power_series<T>& a, const power_series<T>& b) {
    auto sum = power_series<T>::zero(std::min(a.order(), b.order()));
    for (int n = 0; n <= sum.order(); ++n) {
        sum[n] = a[n] + b[n];
    }
    return sum;
}

/// a - b. O(N).
template <ring T>
power_series<T> operator-(const power_series<T>& a, const power_series<T>& b) {
    auto difference = power_series<T>::zero(std::min(a.order(), b.order()));
    for (int n = 0; n <= difference.order(); ++n) {
        difference[n] = a[n] - b[n];
    }
    return difference;
}

/// Cauchy product, (ab)_n = sum_k a_k b_{n-k}: product() of convolution.hpp.
template <ring T>
power_series<T> operator*(const power_series<T>& a, const power_series<T>& b) {
    return product(a, b);
}

/// q = a / b with b q = a: quotient() of convolution.hpp. b_0 must be nonzero.
template <field T>
power_series<T> operator/(const power_series<T>& a, const power_series<T>& b) {
    return quotient(a, b);
}

/// a': order N - 1 (of a constant: the zero series of order 0). O(N).
template <ring T>
power_series<T> derivative(const power_series<T>& a) {
    auto result = power_series<T>::zero(std::max(a.order() - 1, 0));
    for (int n = 1; n <= a.order(); ++n) {
        result[n - 1] = a[n] * n;
    }
    return result;
}

/// constant + int_0^x a: order N + 1. O(N).
template <field T>
power_series<T> integral(const power_series<T>& a, const T& constant) {
    auto result = power_series<T>::zero(a.order() + 1);
    result[0] = constant;
    for (int n = 0; n <= a.order(); ++n) {
        result[n + 1] = a[n] / (n + 1);
    }
    return result;
}

/// Value and derivative of the polynomial at x, by Horner's rule or in blocks (polynomial_blocks.hpp). O(N).
template <ring T>
jet<T> evaluate(const power_series<T>& a, const T& x) {
    if (polynomial_blocks<T>::serve(a, x)) {
        return polynomial_blocks<T>(a, x).value_and_slope();
    }
    const int order = a.order();
    if (order == 0) {
        return {a[0], T(0)};
    }
    // The first step, by the operators, determines the precision of the others.
    jet<T> result{a[order] * x + a[order - 1], T(0) * x + a[order]};
    for (int n = order - 2; n >= 0; --n) {
        horner_step(result.slope, x, result.value);
        horner_step(result.value, x, a[n]);
    }
    return result;
}

/// The value alone: the same roundings as evaluate(), at half the cost.
template <ring T>
T evaluate_value(const power_series<T>& a, const T& x) {
    if (polynomial_blocks<T>::serve(a, x)) {
        return polynomial_blocks<T>(a, x).value();
    }
    const int order = a.order();
    if (order == 0) {
        return a[0];
    }
    T value = a[order] * x + a[order - 1];
    for (int n = order - 2; n >= 0; --n) {
        horner_step(value, x, a[n]);
    }
    return value;
}

/// The polynomial about another point: b with sum_j b_j y^j = sum_n a_n (c + y)^n, by repeated division by
/// x - c (Horner). O(N^2).
template <ring T>
power_series<T> about(power_series<T> a, const T& c) {
    for (int j = 0; j < a.order(); ++j) {
        for (int n = a.order() - 1; n >= j; --n) {
            a[n] += a[n + 1] * c;
        }
    }
    return a;
}

}  // namespace libration::series
