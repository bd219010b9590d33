// Solutions that decay like a power of the time.
#pragma once

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// Whether the question is about y(inf) = 0 of an equation of power_equation.hpp.
bool is_power_decay(const connection_question& question);

/// The unknown for which t y'/y tends to -m: by searched_decay() for the system in log t, from the initial point if it is positive, from
/// a later time if it is 0, up to which the equation is continued in a root of t, in which it is regular if all powers of t in it are larger than -1; autonomous
/// equations are shifted. Throws error like proved_connection.
connection proved_power_decay(const connection_question& question, const proof_route& route, const march_watch& watch);

}  // namespace libration::ode
