// First guesses between two values from which solutions leave the equilibrium on different sides.
#pragma once

#include <vector>

#include "connection_map.hpp"

namespace libration::ode {

/// For a single unknown number, and an equilibrium with one unstable direction: values at which the side changes on which a solution leaves after
/// its nearest approach, by bisection in floating-point arithmetic between neighbours of `values`, if the solution there comes near to the
/// equilibrium. In the order of the neighbours; none for other questions. Chooses coordinates of the map.
std::vector<double> changes_of_side(connection_map& map, std::vector<double> values, int side);

}  // namespace libration::ode
