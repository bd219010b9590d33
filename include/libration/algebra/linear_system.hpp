// Small dense systems of linear equations, as fits of series ask for.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/series/convolution.hpp"

namespace libration {

/// The solution of a square system A x = b by Gaussian elimination; rows are scaled by their largest entry to choose
/// the pivot. O(n^3). std::nullopt where no pivot is above `negligible` times the largest entry of its row:
/// the system is singular as far as can be told.
template <rounding_scalar T>
std::optional<std::vector<T>> solve_linear(std::vector<std::vector<T>> a, std::vector<T> b, const T& negligible) {
    using std::abs;
    const std::size_t n = b.size();
    std::vector<T> largest(n, T(0));
    for (std::size_t i = 0; i < n; ++i) {
        for (const T& entry : a[i]) {
            largest[i] = abs(entry) > largest[i] ? abs(entry) : largest[i];
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            pivot = abs(a[i][k]) * largest[pivot] > abs(a[pivot][k]) * largest[i] ? i : pivot;
        }
        if (abs(a[pivot][k]) <= largest[pivot] * negligible) {
            return std::nullopt;
        }
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        std::swap(largest[k], largest[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const T factor = -a[i][k] / a[k][k];
            for (std::size_t j = k + 1; j < n; ++j) {
                add_product(a[i][j], factor, a[k][j]);
            }
            add_product(b[i], factor, b[k]);
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) {
            add_product(b[k], T(-a[k][j]), b[j]);
        }
        b[k] /= a[k][k];
    }
    return b;
}

}  // namespace libration
