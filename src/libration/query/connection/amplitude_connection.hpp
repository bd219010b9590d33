// Solutions with a given amplitude of their decay at infinity.
#pragma once

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

bool has_amplitude(const connection_question& question);

/// The solution with y = y(inf) + A exp(-r |t|) + smaller terms, r the rate of the one direction of exponential decay to an
/// equilibrium: theta at the initial point is A exp(+-r t0) divided by the entry of the column [docs/theorems/infinity.md]. The unknowns
/// are the initial values of all unknowns and lower derivatives. Throws error of the subject "conditions" for limits at both
/// ends, several amplitudes, and other numbers of directions, of "unknowns" for other unknowns, and like
/// proved_connection().
connection proved_by_amplitude(const connection_question& question, const proof_route& route, const march_watch& watch);

}  // namespace libration::ode
