// Small dense systems of linear equations, as needed for fitting series.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libration/series/convolution.hpp"

namespace libration {

/// The solution of a square system A x = b by Gaussian elimination; rows are scaled by their largest entry to choose
/// the pivot. O(n^3). Returns std::nullopt if no pivot is above `negligible` times the largest entry of its row:
/// the system is then numerically singular.
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

/// A system that grows by one equation at a time: Gaussian elimination by rows, with the pivot chosen among the
/// columns. Equations shared by several systems are eliminated once: keep() returns to them. Entries are reduced by
/// inner products with a column of the previous equations. Memory allocated for dropped equations is reused.
template <rounding_scalar T>
class growing_system {
public:
    /// For this number of unknowns. An equation is dependent if no entry of its reduced row is above `negligible` times
    /// its largest coefficient.
    growing_system(std::size_t unknowns, T negligible)
        : negligible_(std::move(negligible)), columns_(unknowns), factors_(unknowns, T(0)) {
        std::iota(columns_.begin(), columns_.end(), std::size_t{0});
    }

    std::size_t unknowns() const { return columns_.size(); }
    std::size_t equations() const { return equations_; }

    /// Adds an equation, given as its coefficients followed by its right-hand side, unless there are already as many
    /// equations as unknowns; returns false if it depends on the previous ones. O(equations unknowns).
    bool add(const std::vector<T>& equation) {
        if (equations_ == unknowns()) {
            return false;
        }
        row_ = equation;
        const T negligible = largest_among(0).size * negligible_;
        subtract_equations();
        const place_of_size pivot = largest_among(equations_);
        if (pivot.size <= negligible) {
            return false;
        }
        std::swap(columns_[equations_], columns_[pivot.place]);
        append();
        return true;
    }

    /// Drops all equations except the first ones.
    void keep(std::size_t equations) { equations_ = std::min(equations, equations_); }

    /// The solution, provided there are as many equations as unknowns. O(n^2).
    std::optional<std::vector<T>> solution() const {
        if (equations_ < unknowns()) {
            return std::nullopt;
        }
        std::vector<T> x(unknowns(), T(0));
        for (std::size_t k = unknowns(); k-- > 0;) {
            // Entries of x that are not computed yet are 0.
            const T* const equation = reduced_.data() + k * width();
            x[columns_[k]] =
                equation[unknowns()] - inner_product(equation, 1, x.data(), 1, static_cast<int>(unknowns()));
        }
        return x;
    }

private:
    std::size_t width() const { return unknowns() + 1; }

    // Subtracts multiples of all equations from the row so that its entries in their pivot columns become 0.
    void subtract_equations() {
        const auto reduce = [&](std::size_t column, std::size_t equations) {
            row_[column] -= inner_product(factors_.data(), 1, reduced_.data() + column, static_cast<int>(width()),
                                          static_cast<int>(equations));
        };
        for (std::size_t k = 0; k < equations_; ++k) {
            reduce(columns_[k], k);
            factors_[k] = row_[columns_[k]];
        }
        for (std::size_t j = equations_; j < unknowns(); ++j) {
            reduce(columns_[j], equations_);
        }
        reduce(unknowns(), equations_);
    }

    struct place_of_size {
        std::size_t place;
        T size;
    };

    // The position of the largest entry of the row among the columns from `first` on.
    place_of_size largest_among(std::size_t first) const {
        using std::abs;
        place_of_size largest{first, abs(row_[columns_[first]])};
        for (std::size_t j = first + 1; j < unknowns(); ++j) {
            if (T size = abs(row_[columns_[j]]); size > largest.size) {
                largest = {j, std::move(size)};
            }
        }
        return largest;
    }

    // Appends the row, divided by its pivot, as the next equation.
    void append() {
        if (reduced_.size() == equations_ * width()) {
            reduced_.resize(reduced_.size() + width(), T(0));
        }
        T* const place = reduced_.data() + equations_ * width();
        const T pivot = row_[columns_[equations_]];
        for (std::size_t j = equations_ + 1; j < unknowns(); ++j) {
            row_[columns_[j]] /= pivot;
        }
        row_.back() /= pivot;
        std::swap_ranges(row_.begin(), row_.end(), place);
        ++equations_;
    }

    T negligible_;
    std::size_t equations_ = 0;
    std::vector<std::size_t> columns_;  ///< pivot columns first, then the others
    /// By equations, the right-hand side last; entries at their pivot, which is 1, and before it are not used.
    std::vector<T> reduced_;
    std::vector<T> row_;      ///< the equation being added
    std::vector<T> factors_;  ///< its multipliers of the previous equations
};

/// Square systems of successive equations, one ending with each equation in `lasts`. Common equations are eliminated
/// once: first the intersection of all, then those of ever smaller groups of neighbours in the list.
template <rounding_scalar T, class Equation>
class sliding_systems {
public:
    /// `equation(k)` returns the coefficients and then the right-hand side of equation k, as expected by
    /// growing_system.
    sliding_systems(std::size_t unknowns, T negligible, Equation equation)
        : unknowns_(static_cast<int>(unknowns)),
          system_(unknowns, std::move(negligible)),
          equation_(std::move(equation)) {}

    /// Calls found(x) with the solution x of each system in turn until it returns false; returns false if it does or if
    /// a system is singular. O(n^3) for the first and n^2 per equation that is not shared.
    template <class Found>
    bool solve(std::span<const int> lasts, const Found& found) {
        system_.keep(0);
        return lasts.empty() || solve_group(lasts, {}, found);
    }

private:
    // Equations first .. end - 1.
    struct interval {
        int first = 0;
        int end = 0;
    };

    template <class Found>
    bool solve_group(std::span<const int> lasts, interval known, const Found& found) {
        const auto [least, greatest] = std::ranges::minmax(lasts);
        const interval shared{greatest - unknowns_ + 1, least + 1};
        if (shared.first < shared.end) {
            if (known.first == known.end) {
                known = {shared.first, shared.first};
            }
            if (!add(known.end, shared.end) || !add(shared.first, known.first)) {
                return false;
            }
            known = shared;
        }
        if (lasts.size() == 1) {
            return found(*system_.solution());
        }
        const std::size_t equations = system_.equations();
        const std::size_t part = widest_gap(lasts);
        const bool go_on = solve_group(lasts.first(part), known, found);
        system_.keep(equations);
        return go_on && solve_group(lasts.subspan(part), known, found);
    }

    bool add(int first, int end) {
        for (int k = first; k < end; ++k) {
            if (!system_.add(equation_(k))) {
                return false;
            }
        }
        return true;
    }

    // The number of equations before it.
    static std::size_t widest_gap(std::span<const int> lasts) {
        std::size_t widest = 1;
        for (std::size_t i = 2; i < lasts.size(); ++i) {
            const auto gap = [&](std::size_t at) { return std::abs(lasts[at - 1] - lasts[at]); };
            widest = gap(i) > gap(widest) ? i : widest;
        }
        return widest;
    }

    int unknowns_;
    growing_system<T> system_;
    Equation equation_;
};

}  // namespace libration
