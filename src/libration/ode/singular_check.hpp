// Checks the initial values of a singular system for consistency with its equations.
#pragma once

#include "libration/ode/tape.hpp"

namespace libration::ode {

/// Throws error if the given coefficients do not satisfy the equations, or if unknowns have fractional powers below a
/// derivative that the equations use. Decided over fractions if all numbers of the problem are fractions, otherwise
/// with 60 digits, of which 30 must agree.
void require_consistent_start(const tape& made, const explicit_system& of);

}  // namespace libration::ode
