// Coordinates at an equilibrium in which an invariant subspace is nearly diagonal.
#pragma once

#include <optional>

#include "frame_plan.hpp"

namespace libration::ode {

/// y - y* = Q w: the first columns span an invariant subspace.
struct linear_frame {
    jet_matrix columns;  ///< Q by rows
    jet_matrix inner;    ///< the linear field in the first coordinates, zero between different blocks
};
/// Encloses the columns, with their derivatives, for all matrices of the balls, by enclosed_block(). std::nullopt if that fails.
std::optional<linear_frame> enclosed_frame(const jet_matrix& linear, const frame_plan& plan);

}  // namespace libration::ode
