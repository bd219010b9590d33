// Ratios of successive coefficients, as in a Domb-Sykes plot.
#pragma once

#include <optional>
#include <vector>

#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

/// One point of the plot.
template <rounding_scalar T>
struct coefficient_ratio {
    int n;    ///< power of x of the later coefficient
    T value;  ///< c_k/c_{k-1}, in x^-stride
};

/// c_k/c_{k-1} for k = 1 .. last where the earlier coefficient is nonzero. For a single singularity x0 in w = x^stride,
/// (1 - x/x0)^nu, the ratio is x0^-stride (1 - stride (nu + 1)/n + O(1/n^2)) [DombSykes]. O(N).
template <rounding_scalar T>
std::vector<coefficient_ratio<T>> ratios_of(const strided_series<T>& c) {
    std::vector<coefficient_ratio<T>> all;
    all.reserve(static_cast<std::size_t>(c.last()));
    for (int k = 1; k <= c.last(); ++k) {
        if (c[k - 1] != 0) {
            all.push_back({c.power(k), T(c[k] / c[k - 1])});
        }
    }
    return all;
}

}  // namespace libration::convergence
