// Radii of a tube that are affine on a step: theorem K1.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// r' >= A r + delta: exact upper bounds of the diagonal of A, with its signs, and of the other entries >= 0, by rows.
struct comparison_system {
    std::vector<ball> diagonal;
    std::vector<magnitude> beside;
    std::vector<magnitude> defect;

    std::size_t size() const { return diagonal.size(); }
};

struct affine_radii {
    std::vector<magnitude> first, last;
};

/// True if r(t), affine from first to last over the length, is proved to satisfy the inequality at both ends.
bool satisfies(const comparison_system& system, const affine_radii& radii, long length);

/// Such radii with first >= start, nearly minimal; std::nullopt if none are found.
std::optional<affine_radii> affine_growth(const comparison_system& system, const std::vector<magnitude>& start,
                                          long length);

}  // namespace libration::ode
