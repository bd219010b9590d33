// First guesses of several unknowns, moved until the solution comes nearer to
// the equilibrium.
#pragma once

#include <vector>

#include "connection_map.hpp"

namespace libration::ode {

/// Free numbers and coordinates near `numbers` from which the solution comes
/// nearer to the equilibrium: the simplex method of Nelder and Mead for the
/// logarithm of the distance of approach_from(), in floating-point arithmetic.
/// The coordinates of the map stay as they are.
std::vector<double> nearer_guess(const connection_map& map, const std::vector<double>& numbers);

}  // namespace libration::ode
