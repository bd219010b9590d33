// Endpoint approximants: a Taylor polynomial at 0 corrected so that it also has the exact value and derivatives at the
// other end of the interval, here x = 1 (scale the variable by the length of the interval first).
//
// Given a_0 .. a_N (Taylor coefficients at 0) and e_0 .. e_(m-1), e_j = f^(j)(1)/j!, the approximant is the unique
// polynomial of degree N + m that agrees with f to order N at 0 and to order m-1 at 1: two-point Hermite interpolation.
// m = 2 is the resummation of the paper [paper (fullresummation)], m = N + 1 the two-point Taylor expansion. Two forms:
//     factored   p(x) = sum_j e_j (x-1)^j + (1-x)^m sum_{n=0}^{N} h_n x^n     [paper (resummation)]
//     corrected  p(x) = sum_{n=0}^{N} a_n x^n + x^(N+1) q(x), deg q < m       [paper (efficient)]
// They are equal as polynomials; the first is accurate near x = 1, the second is the cheapest. For an f analytic in |x|
// < r, r > 1, and a fixed m the rate on [0,1] is that of the series, r^-N; the norm of the error gains a factor N^-m.
// For m = N + 1 it is (1/(4 min |z (z-1)|))^N over the singularities z of f, because |x (1-x)| <= 1/4: convergent if
// that is below 1, also for r <= 1, and divergent if it is above.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "libration/series/arithmetic.hpp"

namespace libration {

/// Coefficients in x of the polynomial sum_j e_j (x-1)^j. O(m^2).
template <scalar T>
std::vector<T> expand_at_zero(const std::vector<T>& endpoint) {
    std::vector<T> result;
    for (auto e = endpoint.rbegin(); e != endpoint.rend(); ++e) {
        result.push_back(T(0));
        for (std::size_t i = result.size() - 1; i > 0; --i) {
            result[i] = result[i - 1] - result[i];
        }
        result[0] = *e - result[0];
    }
    return result;
}

/// b = a - sum_j e_j (x-1)^j, which the inner series times (1-x)^m has to equal [paper (b)].
template <scalar T>
series::power_series<T> endpoint_remainder(series::power_series<T> series, const std::vector<T>& endpoint) {
    const std::vector<T> polynomial = expand_at_zero(endpoint);
    for (int n = 0; n <= series.order() && n < static_cast<int>(polynomial.size()); ++n) {
        series[n] -= polynomial[static_cast<std::size_t>(n)];
    }
    return series;
}

/// h = (1-x)^-m b by the Cauchy product with the binomial series, h_n = sum_k C(k+m-1, m-1) b_(n-k)
/// [paper (approxcoeffs)]. O(N^2).
template <scalar T>
series::power_series<T> inner_series_by_convolution(const series::power_series<T>& series,
                                                    const std::vector<T>& endpoint) {
    const int m = static_cast<int>(endpoint.size());
    auto binomial = series::power_series<T>::zero(series.order());
    binomial[0] = T(m == 0 ? 0 : 1);
    for (int k = 1; k <= series.order(); ++k) {
        binomial[k] = binomial[k - 1] * (k + m - 1) / k;
    }
    return m == 0 ? series : binomial * endpoint_remainder(series, endpoint);
}

/// h by m running sums, each a division by 1 - x. O(m N) additions and no multiplications.
template <scalar T>
series::power_series<T> inner_series(const series::power_series<T>& series, const std::vector<T>& endpoint) {
    series::power_series<T> inner = endpoint_remainder(series, endpoint);
    for (std::size_t pass = 0; pass < endpoint.size(); ++pass) {
        for (int n = 1; n <= inner.order(); ++n) {
            inner[n] += inner[n - 1];
        }
    }
    return inner;
}

/// The corrected form as one power series of order N + m. With d_j the Taylor coefficients at 1 of f - sigma_N,
/// q = sum_i q_i (x-1)^i, q_i = sum_{j<=i} d_j C(-N-1, i-j): for m = 2 the alpha and beta of the paper's appendix in
/// the scaled variable, without a power of T*. O(m N).
template <scalar T>
series::power_series<T> endpoint_corrected(const series::power_series<T>& series, const std::vector<T>& endpoint) {
    const int m = static_cast<int>(endpoint.size());
    const int order = series.order();
    // Taylor coefficients of sigma_N at 1 by repeated Horner division.
    std::vector<T> rest = series.coefficients();
    std::vector<T> defect;
    for (int j = 0; j < m; ++j) {
        T value(0);
        if (j <= order) {
            for (int n = order; n > j; --n) {
                rest[static_cast<std::size_t>(n) - 1] += rest[static_cast<std::size_t>(n)];
            }
            value = rest[static_cast<std::size_t>(j)];
        }
        defect.push_back(endpoint[static_cast<std::size_t>(j)] - value);
    }
    std::vector<T> correction(static_cast<std::size_t>(m), T(0));
    for (int i = 0; i < m; ++i) {
        T binomial(1);  // C(-N-1, l)
        for (int l = 0; l <= i; ++l) {
            correction[static_cast<std::size_t>(i)] += defect[static_cast<std::size_t>(i - l)] * binomial;
            binomial = -binomial * (order + 1 + l) / (l + 1);
        }
    }
    series::power_series<T> result = series;
    for (const T& coefficient : expand_at_zero(correction)) {
        result.push_back(coefficient);
    }
    return result;
}

/// The factored form as a function of x in [0, 1].
template <scalar T>
class endpoint_approximant {
public:
    /// series: a_0 .. a_N about 0; endpoint: f^(j)(1)/j! for j < m, m >= 0.
    endpoint_approximant(const series::power_series<T>& series, const std::vector<T>& endpoint)
        : conditions_(endpoint.size()),
          endpoint_(endpoint.empty() ? series::power_series<T>() : series::power_series<T>(endpoint)),
          inner_(inner_series(series, endpoint)) {}

    int order() const { return inner_.order(); }
    /// h_0 .. h_N; the paper's a-hat_n is h_n / T*^(n+2).
    const series::power_series<T>& inner() const { return inner_; }

    /// Value and derivative at x. O(N + m).
    series::jet<T> operator()(const T& x) const {
        series::jet<T> at = evaluate(inner_, x);
        const T to_end = 1 - x;
        for (std::size_t pass = 0; pass < conditions_; ++pass) {
            at.slope = at.slope * to_end - at.value;
            at.value *= to_end;
        }
        const series::jet<T> end = evaluate(endpoint_, T(-to_end));
        return {at.value + end.value, at.slope + end.slope};
    }

    /// The value alone, computed as in operator() at half the cost.
    T value(const T& x) const {
        T at = evaluate_value(inner_, x);
        const T to_end = 1 - x;
        for (std::size_t pass = 0; pass < conditions_; ++pass) {
            at *= to_end;
        }
        return at + evaluate_value(endpoint_, T(-to_end));
    }

private:
    std::size_t conditions_;            // m
    series::power_series<T> endpoint_;  // in powers of x - 1; 0 if there is no condition
    series::power_series<T> inner_;
};

}  // namespace libration
