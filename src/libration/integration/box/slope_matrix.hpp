// The comparison system of theorem G: a bound of the slopes of the right-hand sides, by its nonzero entries.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// M by rows: M_ii with its sign, as an exact upper bound, and M_ij >= 0 for the other pairs of unknowns that depend on
/// each other. Memory: linear in their number.
struct slope_matrix {
    /// The entries next to the diagonal of row i are those from first[i] up to first[i + 1].
    std::vector<std::size_t> first{0};
    std::vector<std::size_t> columns;
    std::vector<magnitude> beside;
    std::vector<ball> diagonal;
    /// Whether the right-hand side is exactly 0 on the whole box.
    std::vector<bool> vanishing = {};

    /// The row of an unknown that stays 0.
    void clear_row(std::size_t i) {
        diagonal[i] = ball(0);
        for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
            beside[k] = magnitude();
        }
    }
    std::size_t size() const { return diagonal.size(); }
};

/// Radii at all distances of a piece of a step, and at its end.
struct grown_radii {
    std::vector<magnitude> most, last;
};

/// r(s) = e^(M s) r(0), which satisfies r' = M r, for 0 <= s <= length: most >= r(s) at every s, last >= r(length). With
/// M = N - c 1, N >= 0, c >= 0,
///     r(s) = e^(-c s) sum_k (N s)^k/k! r(0) <= sum_(k <= K) (N s)^k/k! r(0) + R_K w,
///     R_K = (nu s)^(K+1)/(K+1)! e^(nu s) max_j r_j(0)/w_j,   N w <= nu w,
/// w >= the weights, which are positive; the rest R_K w is added to the unknowns that N couples, directly or indirectly, to one with
/// r_j(0) > 0, and the others remain 0: in all powers of N their entries are 0. All terms are nonnegative and rounded up.
/// Where c length > 1, in shorter steps with the same M. Returns std::nullopt if nu length is too large, or M or r(0) not
/// finite. O(K) products with N.
std::optional<grown_radii> grown(const slope_matrix& of, const std::vector<magnitude>& start, const magnitude& length,
                                 const std::vector<magnitude>& weights);

}  // namespace libration::ode
