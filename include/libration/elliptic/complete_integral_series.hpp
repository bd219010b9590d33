// Partial sums of the two power series of K(k) in the paper. They are approximations by definition: nothing is
// enclosed here, and the error is what the studies measure.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/elliptic/modulus.hpp"
#include "libration/scalar/inverse_hyperbolic.hpp"

namespace libration {

/// Refuses a negative order of a partial sum.
inline void require_order(int order) {
    if (order < 0) {
        throw std::invalid_argument("order " + std::to_string(order) + " of a partial sum");
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
/// k'^2. O(N).
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

/// sum_{n=0}^{N} [(pi/2) ((2n)!/n!^2)^2 16^-n - 1/(2n+1)] k^(2n) + artanh(k)/k [paper (Knew)]. The brackets behave as
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

}  // namespace libration
