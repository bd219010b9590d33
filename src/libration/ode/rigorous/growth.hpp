// Radii of a tube that are affine on a step: theorem K1.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// r' >= A r + delta: the diagonal of A with its signs, as exact upper bounds, what is beside it >= 0, by rows.
struct comparison_system {
    std::vector<ball> diagonal;
    std::vector<magnitude> beside;
    std::vector<magnitude> defect;

    std::size_t size() const { return diagonal.size(); }
};

struct affine_radii {
    std::vector<magnitude> first, last;
};

/// Whether r(t) from first to last over the length satisfies the inequality at both ends, decided in balls.
bool satisfies(const comparison_system& system, const affine_radii& radii, long length);

/// Such radii with first >= start, about the least ones; std::nullopt where none are found.
std::optional<affine_radii> affine_growth(const comparison_system& system, const std::vector<magnitude>& start,
                                          long length);

}  // namespace libration::ode
