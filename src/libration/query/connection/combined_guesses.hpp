// First guesses of all unknowns of a connecting orbit.
#pragma once

#include <vector>

#include "connection_map.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// The first guesses that are given, with all combinations of values for those
/// that are not, and 1 for free coordinates, a single one of both signs.
std::vector<std::vector<double>> combined_guesses(const connection_map& map, const connection_question& question);

}  // namespace libration::ode
