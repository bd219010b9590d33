// Partial sums of the two power series of K(k) in the paper, and proved bounds on their remainders. The sums are
// approximations by definition: nothing is enclosed here, and the studies measure their error.
//
// With c_n = (pi/2) ((2n)!/n!^2)^2 16^-n and b_n = c_n - 1/(2n+1) the remainders are sum_{n>N} c_n k^(2n) and sum_{n>N}
// b_n k^(2n). From c_{n+1}/c_n = ((2n+1)/(2n+2))^2,
//     (2n+1) c_n falls, as (2n+1)(2n+3) < (2n+2)^2, and tends to 1 (Wallis): so b_n > 0, and both sums are always below
//     K; and c_n <= (2N+3) c_{N+1}/(2n+1) for n > N;
//     (4n+1) c_n rises, as (4n+5)(2n+1)^2 = (4n+1)(2n+2)^2 + 1, and tends to 2: so b_n < 1/((4n+1)(2n+1)).
// The sums that remain are bounded by telescoping, with d = k'^2:
//     sum_{j>=0} k^(2j)/(q+j+1/2) <= G(q) = log(1 + 1/(q d)), because
//     G(q) - k^2 G(q+1) = log(1 + 1/q) - log(1 + 1/(q + 1/d)) + d log(1 + 1/((q+1) d)) >= 1/(q+1/2): the first term
//     is at least that, and the last, int_0^1 ds/(q+1+s/d), outweighs the second, int_0^1 ds/(q+s+1/d), because
//     q+1+s/d <= q+s+1/d;
//     sum_{j>=0} k^(2j)/((q+j)(q+j+1)) <= H(q) = 1/(q (1 + q d)), because H(q) - k^2 H(q+1) - 1/(q (q+1)) =
//     k^2 d/((q+1) (1+q d) (1+(q+1) d)) >= 0.
// The first with q = N+1 is used for (Kold), the second with q = N+7/8 for (Knew), as (4n+1)(2n+1) > 8 (n-1/8)(n+7/8).
#pragma once

#include <string>

#include "libration/elliptic/modulus.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/inverse_hyperbolic.hpp"

namespace libration::elliptic {

/// Throws error for a negative order of a partial sum.
inline void require_order(int order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "of a partial sum is negative");
    }
}

/// artanh(k)/k, 1 at k = 0. artanh k = arsinh(k/k'): no cancellation at either end, hence no branch.
template <scalar T>
T artanh_over_modulus(const modulus<T>& m) {
    if (binary_exponent(m.k) == exponent_of_zero) {
        return T(1);
    }
    return arsinh(T(m.k / m.complement)) / m.k;
}

/// sum_{n=0}^{N} (pi/2) ((2n)!/n!^2)^2 16^-n k^(2n) [paper (Kold)]. The remainder is below its first omitted term over
/// k'^2, and below complete_integral_series_bound() also near k = 1. O(N).
template <scalar T>
T complete_integral_series(const modulus<T>& m, int order) {
    require_order(order);
    const T parameter = m.k * m.k;
    T term = pi<T>() / 2;
    T sum = term;
    for (int n = 1; n <= order; ++n) {
        const T ratio = T(2 * n - 1) / (2 * n);
        term *= ratio * ratio * parameter;
        sum += term;
    }
    return sum;
}

/// sum_{n=0}^{N} [(pi/2) ((2n)!/n!^2)^2 16^-n - 1/(2n+1)] k^(2n) + artanh(k)/k [paper (Knew)]. The brackets behave like
/// 1/(8 n^2), so that at k = 1 the error decays only like 1/(8 N). O(N).
template <scalar T>
T complete_integral_resummed(const modulus<T>& m, int order) {
    require_order(order);
    const T parameter = m.k * m.k;
    T binomial = pi<T>() / 2;
    T power(1);
    T sum = binomial - 1;
    for (int n = 1; n <= order; ++n) {
        const T ratio = T(2 * n - 1) / (2 * n);
        binomial *= ratio * ratio;
        power *= parameter;
        sum += (binomial - T(1) / (2 * n + 1)) * power;
    }
    return sum + artanh_over_modulus(m);
}

/// Bound on K - complete_integral_series(m, N), proved above: (2N+3) c_{N+1} k^(2N+2) log(1 + 1/((N+1) k'^2))/2.
/// Between 1 and 2 times the remainder for every k. It has the rounding error of a few operations and of log(1 + x).
/// O(N).
template <scalar T>
T complete_integral_series_bound(const modulus<T>& m, int order) {
    require_order(order);
    using std::log;
    T term = pi<T>() / 2;  // c_n k^(2n)
    for (int n = 1; n <= order + 1; ++n) {
        const T ratio = m.k * (2 * n - 1) / (2 * n);
        term *= ratio * ratio;
    }
    return term * (2 * order + 3) * log(T(1 + 1 / (m.complement * m.complement * (order + 1)))) / 2;
}

/// Bound on K - complete_integral_resummed(m, N), proved above: k^(2N+2)/((8N+7) (1 + (N+7/8) k'^2)). It is asymptotic
/// to the remainder as k -> 1 and N -> infinity. O(log N).
template <scalar T>
T complete_integral_resummed_bound(const modulus<T>& m, int order) {
    require_order(order);
    using std::pow;
    const int q = 8 * order + 7;
    return pow(T(m.k * m.k), order + 1) * 8 / q / (8 + m.complement * m.complement * q);
}

}  // namespace libration::elliptic
