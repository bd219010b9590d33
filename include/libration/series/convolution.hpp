// The one place where two coefficient sequences are convolved; every product in this library goes through it.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "libration/scalar/supplied_quotient.hpp"
#include "libration/series/power_series.hpp"

namespace libration {

/// Which degrees of a series may be non-zero, known from a symmetry (never guessed from the values).
enum class parity { any, even, odd };

/// sum += a * b, with one rounding where the arithmetic has a fused operation.
template <scalar T>
void add_product(T& sum, const T& a, const T& b) {
    if constexpr (std::same_as<T, mpfr>) {
        mpfr_fma(handle(sum), handle(a), handle(b), handle(sum), MPFR_RNDN);
    } else {
        sum += a * b;
    }
}

/// sum_i x[i] y[step i], i < count, in four partial sums, which compilers turn into vector instructions; the four are
/// the same whatever the width of a vector, and so is the result. O(count).
template <int step>
double sum_in_lanes(const double* x, const double* y, int count) {
    constexpr int lanes = 4;
    std::array<double, lanes> sums{};
    const int whole = count - count % lanes;
    for (int i = 0; i < whole; i += lanes) {
        for (int lane = 0; lane < lanes; ++lane) {
            sums[static_cast<std::size_t>(lane)] += x[i + lane] * y[(i + lane) * step];
        }
    }
    for (int i = whole; i < count; ++i) {
        sums[static_cast<std::size_t>(i - whole)] += x[i] * y[i * step];
    }
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

/// sum_i x[i x_step] y[i y_step], i < count; on balls with one rounding at the end, in double over neighbours by
/// sum_in_lanes (long double and quad have no vectors). O(count).
template <scalar T>
T inner_product(const T* x, int x_step, const T* y, int y_step, int count) {
    if constexpr (proved_scalar<T>) {
        return sum_of_products(x, x_step, y, y_step, count);
    } else {
        if constexpr (std::same_as<T, double>) {
            if (x_step == 1 && (y_step == 1 || y_step == -1)) {
                return y_step == 1 ? sum_in_lanes<1>(x, y, count) : sum_in_lanes<-1>(x, y, count);
            }
        }
        T sum(0);
        for (int i = 0; i < count; ++i) {
            add_product(sum, x[i * x_step], y[i * y_step]);
        }
        return sum;
    }
}

/// sum_{k=first}^{last} a_k b_{n-k}, over the k of the parity that a has.
/// The indices must exist: 0 <= first, last <= order of a, 0 <= n - last, n - first <= order of b. O(last - first).
template <scalar T>
T convolution(const power_series<T>& a, const power_series<T>& b, int n, int first, int last,
              parity of_a = parity::any) {
    const int step = of_a == parity::any ? 1 : 2;
    if (of_a != parity::any && (first % 2 == 0) != (of_a == parity::even)) {
        ++first;
    }
    return first > last ? T(0) : inner_product(&a[first], step, &b[n - first], -step, (last - first) / step + 1);
}

/// The coefficient of x^n in a b: sum_{k=0}^{n} a_k b_{n-k}.
template <scalar T>
T product_coefficient(const power_series<T>& a, const power_series<T>& b, int n, parity of_a = parity::any) {
    return convolution(a, b, n, 0, n, of_a);
}

/// The coefficient of x^n in a^2, each pair of equal products formed once: half the cost of product_coefficient.
template <scalar T>
T square_coefficient(const power_series<T>& a, int n, parity of_a = parity::any) {
    T sum = convolution(a, a, n, 0, (n - 1) / 2 - (n == 0 ? 1 : 0), of_a);
    sum += sum;
    const bool middle_may_count = of_a == parity::any || ((n / 2) % 2 == 0) == (of_a == parity::even);
    if (n % 2 == 0 && middle_may_count) {
        add_product(sum, a[n / 2], a[n / 2]);
    }
    return sum;
}

/// a b, of the smaller order. O(N^2) products; on balls one product of whole sequences (scalar/ball_polynomial.hpp),
/// about O(N) products, whose radii are those of the larger coefficients.
template <scalar T>
power_series<T> product(const power_series<T>& a, const power_series<T>& b) {
    if constexpr (proved_scalar<T>) {
        return power_series<T>(whole_product(a.coefficients(), b.coefficients()));
    } else {
        auto result = power_series<T>::zero(std::min(a.order(), b.order()));
        for (int n = 0; n <= result.order(); ++n) {
            result[n] = product_coefficient(a, b, n);
        }
        return result;
    }
}

/// q = a / b, of the smaller order, from b q = a: q_n = (a_n - sum_{k=1}^{n} b_k q_{n-k}) / b_0. b_0 must not be 0.
/// O(N^2) products; on balls one quotient of whole sequences, the cost of a few such products.
template <scalar T>
power_series<T> quotient(const power_series<T>& a, const power_series<T>& b) {
    if constexpr (proved_scalar<T>) {
        return power_series<T>(whole_quotient(a.coefficients(), b.coefficients()));
    } else {
        auto result = power_series<T>::zero(std::min(a.order(), b.order()));
        for (int n = 0; n <= result.order(); ++n) {
            result[n] = (a[n] - convolution(b, result, n, 1, n)) / b[0];
        }
        return result;
    }
}

/// Whether quotients of whole sequences cost about O(N) products: on balls, and in mpfr where FLINT is linked.
template <scalar T>
bool has_whole_quotients() {
    if constexpr (std::same_as<T, mpfr>) {
        return supplied_quotient != nullptr;
    } else {
        return proved_scalar<T>;
    }
}

/// quotient() for series that are scaled to their circle of convergence, where an error relative to the largest
/// coefficient is small beside each of them: by whole sequences in mpfr too, within 2^48 epsilon of the largest.
template <scalar T>
power_series<T> scaled_quotient(const power_series<T>& a, const power_series<T>& b) {
    if constexpr (std::same_as<T, mpfr>) {
        if (supplied_quotient != nullptr) {
            if (auto q = supplied_quotient(a.coefficients(), b.coefficients())) {
                return power_series<T>(std::move(*q));
            }
        }
    }
    return quotient(a, b);
}

}  // namespace libration
