// First guesses of connecting orbits in floating-point arithmetic, on which no proof depends.
#pragma once

#include <optional>
#include <vector>

#include "connection_map.hpp"

namespace libration::ode {

/// Where a solution comes nearest to the equilibrium at its end.
struct nearest_approach {
    double time = 0;
    double nearest_time = 0;    ///< of the first local minimum of the distance that is nearly the least
    double distance = 0;        ///< relative to the size of the equilibrium, without free coordinates
    std::vector<double> state;  ///< of the moving unknowns
};

/// The approach of the solution from first guesses of the numbers, and of the coordinates of the equilibria.
std::optional<nearest_approach> approach_from(const connection_map& map, const std::vector<double>& x);

/// All unknowns of the map near a solution: Newton's method at the time of the nearest approach, then at later times,
/// until theta is small. Sets the time, the radius and the coordinates of the map. `numbers` are the first guesses of free
/// numbers and coordinates; std::nullopt if Newton's method does not converge.
std::optional<std::vector<double>> candidate_from(connection_map& map, const std::vector<double>& numbers, int side);

}  // namespace libration::ode
