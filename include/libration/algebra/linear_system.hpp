// Small dense systems of linear equations, as fits of series ask for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
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

/// A system that grows by one equation at a time: Gaussian elimination by rows, the pivot chosen among the columns. What
/// several systems share of their equations is eliminated once: keep() goes back to it.
template <rounding_scalar T>
class growing_system {
public:
    /// For so many unknowns. An equation is dependent where none of what is left of it is above `negligible` times its
    /// largest coefficient.
    growing_system(std::size_t unknowns, T negligible) : negligible_(std::move(negligible)), columns_(unknowns) {
        std::iota(columns_.begin(), columns_.end(), std::size_t{0});
        rows_.reserve(unknowns);
    }

    std::size_t unknowns() const { return columns_.size(); }
    std::size_t equations() const { return rows_.size(); }

    /// Takes an equation, its coefficients and then its right side, unless there are as many as unknowns; false where it
    /// depends on those before. O(equations unknowns).
    bool add(std::vector<T> row) {
        using std::abs;
        if (equations() == unknowns()) {
            return false;
        }
        T largest(0);
        for (std::size_t j = 0; j < unknowns(); ++j) {
            largest = std::max(largest, T(abs(row[j])));
        }
        for (std::size_t k = 0; k < equations(); ++k) {
            subtract(rows_[k], k, row);
        }
        const std::size_t pivot = largest_left(row);
        if (abs(row[columns_[pivot]]) <= largest * negligible_) {
            return false;
        }
        std::swap(columns_[equations()], columns_[pivot]);
        normalise(row);
        rows_.push_back(std::move(row));
        return true;
    }

    /// Forgets all equations but the first ones.
    void keep(std::size_t equations) { rows_.resize(std::min(equations, rows_.size())); }

    /// The solution where there are as many equations as unknowns. O(n^2).
    std::optional<std::vector<T>> solution() const {
        if (equations() < unknowns()) {
            return std::nullopt;
        }
        std::vector<T> x(unknowns(), T(0));
        for (std::size_t k = unknowns(); k-- > 0;) {
            T known(0);
            for (std::size_t j = k + 1; j < unknowns(); ++j) {
                add_product(known, rows_[k][columns_[j]], x[columns_[j]]);
            }
            x[columns_[k]] = rows_[k].back() - known;
        }
        return x;
    }

private:
    // Takes a multiple of the k-th equation off a row, so that its pivot's column becomes 0.
    void subtract(const std::vector<T>& equation, std::size_t k, std::vector<T>& row) const {
        const T factor = -row[columns_[k]];
        if (factor == 0) {
            return;
        }
        for (std::size_t j = k + 1; j < unknowns(); ++j) {
            add_product(row[columns_[j]], factor, equation[columns_[j]]);
        }
        add_product(row.back(), factor, equation.back());
    }

    // The place among the columns without a pivot where a row is largest.
    std::size_t largest_left(const std::vector<T>& row) const {
        using std::abs;
        std::size_t pivot = equations();
        T largest = abs(row[columns_[pivot]]);
        for (std::size_t j = pivot + 1; j < unknowns(); ++j) {
            if (T size = abs(row[columns_[j]]); size > largest) {
                largest = std::move(size);
                pivot = j;
            }
        }
        return pivot;
    }

    // Divides a row by its pivot.
    void normalise(std::vector<T>& row) const {
        const T pivot = row[columns_[equations()]];
        for (std::size_t j = equations() + 1; j < unknowns(); ++j) {
            row[columns_[j]] /= pivot;
        }
        row.back() /= pivot;
    }

    T negligible_;
    std::vector<std::size_t> columns_;  ///< those of the pivots, then the others
    std::vector<std::vector<T>> rows_;  ///< reduced, with the pivot 1 that is not written
};

}  // namespace libration
