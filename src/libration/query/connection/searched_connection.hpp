// Connecting orbits of a system with an equilibrium, by theorems W and C.
#pragma once

#include "connection_map.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// As proved_connection() documents, of an autonomous system for limits that are those of an equilibrium, which itself is a solution
/// that is meant; with a rule, the initial values of the first unknowns are its instead of the typed ones. Without the orbit.
connection searched_decay(const connection_question& question, const start_rule& begins, const proof_route& route,
                          const march_watch& watch);

}  // namespace libration::ode
