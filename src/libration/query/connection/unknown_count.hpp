// How many unknowns the limits at infinity determine.
#pragma once

#include <cstddef>

#include "connection_map.hpp"

namespace libration::ode {

/// Throws error unless n = m + k^+ + k^- - 1 + the free coordinates, for m unknowns, n components of the state, and manifolds of k^+ and k^-
/// dimensions for the coordinates that the map has chosen; of the subject "conditions" for ends that are not supported.
void require_square(const connection_map& map, std::size_t unknowns);

}  // namespace libration::ode
