// Products, squares and quotients of coefficient sequences, one coefficient at a time on arrays owned by the caller
// (used by kernel.hpp) and of whole series; every product in this library goes through
// inner_product().
#pragma once

#include <algorithm>
#include <utility>

#include "libration/scalar/inner_product.hpp"
#include "libration/series/power_series.hpp"

namespace libration::series {

/// The degrees in which a series may be nonzero, known from a symmetry (never guessed from the values).
enum class parity { any, even, odd };

/// The parity of the derivative.
constexpr parity opposite(parity p) {
    return p == parity::any ? parity::any : p == parity::even ? parity::odd : parity::even;
}

/// The degrees first, first + stride, first + 2 stride, ..., in which a series may be nonzero.
struct progression {
    int stride = 1;
    int first = 0;  ///< below the stride

    constexpr progression(int of_stride, int of_first) : stride(of_stride), first(of_first) {}
    /// Every second degree.
    constexpr progression(parity p) : stride(p == parity::any ? 1 : 2), first(p == parity::odd ? 1 : 0) {}
    /// The smallest of these degrees that is not below n >= 0.
    constexpr int from(int n) const {
        const int behind = (n - first) % stride;
        return behind == 0 ? n : n + (behind > 0 ? stride - behind : -behind);
    }
    constexpr bool holds(int n) const { return (n - first) % stride == 0; }
};

/// The degrees of the derivative.
constexpr progression degrees_of_slope(progression of) { return {of.stride, (of.first + of.stride - 1) % of.stride}; }

/// sum_{k=first}^{last} a_k b_{n-k}, over the k in which a may be nonzero.
/// The indices must exist: 0 <= first, last <= order of a, 0 <= n - last, n - first <= order of b. O(last - first).
template <ring R>
R convolution(const R* a, const R* b, int n, int first, int last, progression of_a = parity::any) {
    const int step = of_a.stride;
    first = of_a.from(first);
    return first > last ? R(0) : inner_product(a + first, step, b + (n - first), -step, (last - first) / step + 1);
}
template <ring R>
R convolution(const power_series<R>& a, const power_series<R>& b, int n, int first, int last,
              progression of_a = parity::any) {
    return convolution(a.data(), b.data(), n, first, last, of_a);
}

/// The coefficient of x^n in a b: sum_{k=0}^{n} a_k b_{n-k}. O(n).
template <ring R>
R product_coefficient(const R* a, const R* b, int n, progression of_a = parity::any) {
    return convolution(a, b, n, 0, n, of_a);
}
template <ring R>
R product_coefficient(const power_series<R>& a, const power_series<R>& b, int n, progression of_a = parity::any) {
    return product_coefficient(a.data(), b.data(), n, of_a);
}

/// Twice sum_{k=first}^{k < n-k} a_k a_{n-k}, plus a_{n/2}^2 if n is even: sum_{k=first}^{n-first} a_k a_{n-k}, each
/// pair of equal products formed once.
template <ring R>
R sum_of_pairs(const R* a, int n, int first, progression of_a = parity::any) {
    R sum = convolution(a, a, n, first, (n - 1) / 2 - (n == 0 ? 1 : 0), of_a);
    sum += sum;
    if (n % 2 == 0 && n / 2 >= first && of_a.holds(n / 2)) {
        add_product(sum, a[n / 2], a[n / 2]);
    }
    return sum;
}

/// The coefficient of x^n in a^2, each pair of equal products formed once: half the cost of product_coefficient.
template <ring R>
R square_coefficient(const R* a, int n, progression of_a = parity::any) {
    return sum_of_pairs(a, n, 0, of_a);
}
template <ring R>
R square_coefficient(const power_series<R>& a, int n, progression of_a = parity::any) {
    return square_coefficient(a.data(), n, of_a);
}

/// The coefficient of x^n in q = a / b, from b q = a: q_n = (a_n - sum_{k=1}^{n} b_k q_{n-k}) / b_0. Reads a_n, b_0 ..
/// b_n and q_0 .. q_{n-1}; b_0 must be nonzero. O(n).
template <field R>
R quotient_coefficient(const R* a, const R* b, const R* q, int n, progression of_b = parity::any) {
    return (a[n] - convolution(b, q, n, 1, n, of_b)) / b[0];
}

/// a b, of the smaller order. O(N^2) products; on balls one product of whole sequences (scalar/ball/polynomial.hpp),
/// about O(N) products, whose radii are those of the larger coefficients.
template <ring R>
power_series<R> product(const power_series<R>& a, const power_series<R>& b) {
    if constexpr (requires { scalar_traits<R>::whole_product(a.coefficients(), b.coefficients()); }) {
        return power_series<R>(scalar_traits<R>::whole_product(a.coefficients(), b.coefficients()));
    } else {
        auto result = power_series<R>::zero(std::min(a.order(), b.order()));
        for (int n = 0; n <= result.order(); ++n) {
            result[n] = product_coefficient(a, b, n);
        }
        return result;
    }
}

/// q = a / b, of the smaller order; b_0 must be nonzero. O(N^2) products by quotient_coefficient(); on balls one
/// quotient of whole sequences, the cost of a few such products.
template <field R>
power_series<R> quotient(const power_series<R>& a, const power_series<R>& b) {
    if constexpr (requires { scalar_traits<R>::whole_quotient(a.coefficients(), b.coefficients()); }) {
        return power_series<R>(scalar_traits<R>::whole_quotient(a.coefficients(), b.coefficients()));
    } else {
        auto result = power_series<R>::zero(std::min(a.order(), b.order()));
        for (int n = 0; n <= result.order(); ++n) {
            result[n] = quotient_coefficient(a.data(), b.data(), result.data(), n);
        }
        return result;
    }
}

}  // namespace libration::series
