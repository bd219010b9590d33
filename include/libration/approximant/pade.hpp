// The Pade approximant [L/M] of a power series: the rational function P/Q, deg P <= L, deg Q <= M, Q(0) = 1, with f -
// P/Q = O(x^(L+M+1)) [DLMF 3.11(iv)]. Its poles converge to those of a meromorphic f, beyond the radius of convergence.
// Rates: for fixed M and an f with M poles in |x| < r and no other singularity there, the error at x falls like
// (|x|/r)^L away from the poles [Baker1996, Montessus's theorem]. With L = M and branch points it falls like exp(-2 M
// G(x)), G the Green function of the complement of the cuts of minimal capacity, with convergence in capacity only
// [Stahl1997].
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// P/Q with Q(0) = 1.
template <scalar T>
struct pade_approximant {
    series::power_series<T> numerator;
    series::power_series<T> denominator;

    /// Value and derivative at x. O(L + M).
    series::jet<T> operator()(const T& x) const {
        const series::jet<T> p = evaluate(numerator, x);
        const series::jet<T> q = evaluate(denominator, x);
        const T value = p.value / q.value;
        return {value, (p.slope - value * q.slope) / q.value};
    }
};

/// [L/M] of a series of order L + M at least. With c_n = 0 for n < 0, sum_{j=0}^{M} q_j c_{L+i-j} = 0 for i = 1 .. M
/// and q_0 = 1, then p = q c up to x^L. solve(a, b) returns the solution of A x = b, or std::nullopt if there is none:
/// then P/Q with Q(0) = 1 does not exist or has smaller degrees. O(L M) and one solution. Throws error if the series is
/// too short.
template <scalar T, class Solve>
std::optional<pade_approximant<T>> pade_by(const series::power_series<T>& series, int numerator_degree,
                                           int denominator_degree, const Solve& solve) {
    const int l = numerator_degree;
    const int m = denominator_degree;
    if (l < 0 || m < 0 || series.order() < l + m) {
        throw error(error_kind::argument, "Pade approximant", "[" + std::to_string(l) + "/" + std::to_string(m) + "]",
                    "needs more than a series of order " + std::to_string(series.order()));
    }
    const auto c = [&](int n) { return n < 0 ? T(0) : series[n]; };
    std::vector<std::vector<T>> a(static_cast<std::size_t>(m), std::vector<T>(static_cast<std::size_t>(m), T(0)));
    std::vector<T> b(static_cast<std::size_t>(m), T(0));
    for (int i = 1; i <= m; ++i) {
        const auto row = static_cast<std::size_t>(i - 1);
        for (int j = 1; j <= m; ++j) {
            a[row][static_cast<std::size_t>(j - 1)] = c(l + i - j);
        }
        b[row] = -series[l + i];
    }
    std::optional<std::vector<T>> solution = solve(std::move(a), std::move(b));
    if (!solution) {
        return std::nullopt;
    }
    std::vector<T> q = *std::move(solution);
    q.insert(q.begin(), T(1));
    series::power_series<T> denominator(std::move(q));
    auto numerator = series::power_series<T>::zero(l);
    for (int n = 0; n <= l; ++n) {
        numerator[n] = convolution(denominator, series, n, 0, n < m ? n : m);
    }
    return pade_approximant<T>{std::move(numerator), std::move(denominator)};
}

/// [L/M] by Gaussian elimination, O(M^3 + L M), with pivots up to `negligible` taken as 0. The system loses digits
/// with every degree of Q: scale x by the radius of convergence and add guard digits to the working precision.
template <rounding_scalar T>
std::optional<pade_approximant<T>> pade(const series::power_series<T>& series, int numerator_degree,
                                        int denominator_degree, const T& negligible) {
    return pade_by(series, numerator_degree, denominator_degree, [&](std::vector<std::vector<T>> a, std::vector<T> b) {
        return solve_linear(std::move(a), std::move(b), negligible);
    });
}

/// [L/M] with `negligible` the rounding error of a pivot, 8 (M + 1) eps.
template <rounding_scalar T>
std::optional<pade_approximant<T>> pade(const series::power_series<T>& series, int numerator_degree,
                                        int denominator_degree) {
    return pade(series, numerator_degree, denominator_degree, T(epsilon<T>() * (8 * (denominator_degree + 1))));
}

}  // namespace libration
