// The consistency of the initial values at a singular initial point.
#pragma once

#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/tape.hpp"

namespace libration::ode {

/// Throws error if the given coefficients do not satisfy the equations, or if unknowns have fractional powers below a
/// derivative that the equations use. Decided by the exact signs of numbers, not by tolerances; also throws error if such
/// a sign is not decided.
void require_consistent_start(const tape& made, const explicit_system& of);

}  // namespace libration::ode
