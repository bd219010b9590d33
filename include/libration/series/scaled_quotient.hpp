// The quotient of series that are scaled to their circle of convergence, by whole sequences if available.
#pragma once

#include <concepts>
#include <utility>
#include <vector>

#include "libration/scalar/supplied_quotient.hpp"
#include "libration/series/convolution.hpp"

namespace libration::series {

/// Whether quotients of whole sequences cost about O(N) products: on balls, and in mpfr within a
/// whole_quotient_scope.
template <scalar T>
bool has_whole_quotients() {
    if constexpr (std::same_as<T, mpfr>) {
        return supplied_quotient() != nullptr;
    } else {
        return requires(const std::vector<T>& a) { scalar_traits<T>::whole_quotient(a, a); };
    }
}

/// quotient() for series that are scaled to their circle of convergence, for which an error relative to the largest
/// coefficient is small compared with each of them: also by whole sequences in mpfr if the program has selected this
/// (whole_quotient_scope), within 2^48 epsilon of the largest.
template <scalar T>
power_series<T> scaled_quotient(const power_series<T>& a, const power_series<T>& b) {
    if constexpr (std::same_as<T, mpfr>) {
        if (const auto by = supplied_quotient()) {
            if (auto q = by(a.coefficients(), b.coefficients())) {
                return power_series<T>(std::move(*q));
            }
        }
    }
    return quotient(a, b);
}

}  // namespace libration::series
