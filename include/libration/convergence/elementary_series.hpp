// Coefficients of functions with elementary recurrences: powers and logarithms of a linear or a quadratic polynomial,
// tangent, secant, Bernoulli numbers.
//
// All return a_0 .. a_N with an error that grows like n eps: known_series.hpp computes them in more digits and rounds
// once. O(N) unless stated otherwise.
#pragma once

#include <utility>
#include <vector>

#include "libration/series/arithmetic.hpp"

namespace libration::convergence {

/// a_0 = first, a_n = step(a_{n-1}, n).
template <rounding_scalar T, class Step>
series::power_series<T> series_by_steps(int order, T first, Step step) {
    auto a = series::power_series<T>::zero(order);
    a[0] = std::move(first);
    for (int n = 1; n <= order; ++n) {
        a[n] = step(a[n - 1], n);
    }
    return a;
}

/// e^t: a_n = a_{n-1}/n.
template <rounding_scalar T>
series::power_series<T> exponential_series(int order) {
    return series_by_steps(order, T(1), [](const T& before, int n) { return T(before / n); });
}

/// (1 - t)^nu: n a_n = (n - 1 - nu) a_{n-1} [DLMF 4.6.7].
template <rounding_scalar T>
series::power_series<T> binomial_series(const T& nu, int order) {
    return series_by_steps(order, T(1), [&](const T& before, int n) { return T(before * (n - 1 - nu) / n); });
}

/// One term weight * log(1 - t/at) or weight/(1 - t/at).
template <rounding_scalar T>
struct weighted_singularity {
    T weight;
    T at;
};

/// sum of weight/(1 - t/at): a_n = sum of weight at^-n.
template <rounding_scalar T>
series::power_series<T> pole_series(const std::vector<weighted_singularity<T>>& terms, int order) {
    auto a = series::power_series<T>::zero(order);
    for (const auto& term : terms) {
        T power = term.weight;
        for (int n = 0; n <= order; ++n, power /= term.at) {
            a[n] += power;
        }
    }
    return a;
}

/// sum of weight * log(1 - t/at): a_n = -(1/n) sum of weight at^-n [DLMF 4.6.1].
template <rounding_scalar T>
series::power_series<T> logarithm_series(const std::vector<weighted_singularity<T>>& terms, int order) {
    auto a = pole_series(terms, order);
    a[0] = T(0);
    for (int n = 1; n <= order; ++n) {
        a[n] /= -n;
    }
    return a;
}

/// (1 - 2 c t + t^2)^nu, the generating function of the Gegenbauer polynomials C_n^(-nu)(c) [DLMF 18.12.4]:
/// n a_n = 2 c (n - 1 - nu) a_{n-1} - (n - 2 - 2 nu) a_{n-2}. -1 <= c <= 1.
template <rounding_scalar T>
series::power_series<T> quadratic_power_series(const T& c, const T& nu, int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        const T older = n == 1 ? T(0) : T(a[n - 2] * (n - 2 - 2 * nu));
        a[n] = (2 * c * (n - 1 - nu) * a[n - 1] - older) / n;
    }
    return a;
}

/// log(1 - 2 c t + t^2) = -2 sum T_n(c) t^n/n with Chebyshev's T_n [DLMF 18.12.9], T_{n+1} = 2 c T_n - T_{n-1}.
template <rounding_scalar T>
series::power_series<T> quadratic_logarithm_series(const T& c, int order) {
    auto a = series::power_series<T>::zero(order);
    T before = c;
    T chebyshev(1);
    for (int n = 1; n <= order; ++n) {
        T next = n == 1 ? c : T(2 * c * chebyshev - before);
        before = std::exchange(chebyshev, std::move(next));
        a[n] = -2 * chebyshev / n;
    }
    return a;
}

/// (1 - t)^alpha (1 + t)^beta: n a_n = (beta - alpha) a_{n-1} + (n - 2 - alpha - beta) a_{n-2}.
template <rounding_scalar T>
series::power_series<T> opposite_powers_series(const T& alpha, const T& beta, int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        const T older = n == 1 ? T(0) : T(a[n - 2] * (n - 2 - alpha - beta));
        a[n] = (a[n - 1] * (beta - alpha) + older) / n;
    }
    return a;
}

/// tan t: f' = 1 + f^2. O(N^2).
template <rounding_scalar T>
series::power_series<T> tangent_series(int order) {
    auto a = series::power_series<T>::zero(order);
    for (int n = 1; n <= order; n += 2) {
        a[n] = (square_coefficient(a, n - 1, series::parity::odd) + (n == 1 ? 1 : 0)) / n;
    }
    return a;
}

/// sec t: f' = f tan t. O(N^2).
template <rounding_scalar T>
series::power_series<T> secant_series(int order) {
    const auto tangent = tangent_series<T>(order);
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 2; n <= order; n += 2) {
        a[n] = product_coefficient(tangent, a, n - 1, series::parity::odd) / n;
    }
    return a;
}

/// t/(e^t - 1), a_n = B_n/n! [DLMF 24.2.1], by its even part u = (t/2) coth(t/2): t u' = u - u^2 + t^2/4, whose sums
/// have terms of one sign, whereas a division by (e^t - 1)/t leaves rounding errors instead of zeros. O(N^2).
template <rounding_scalar T>
series::power_series<T> bernoulli_series(int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 2; n <= order; n += 2) {
        const T products = square_coefficient(a, n, series::parity::even);  // a_n is still 0
        a[n] = ((n == 2 ? T(1) / 4 : T(0)) - products) / (n + 1);
    }
    if (order >= 1) {
        a[1] = T(-1) / 2;
    }
    return a;
}

}  // namespace libration::convergence
