// Whether the starts of a singular system agree with its equations.
#pragma once

#include "libration/ode/tape.hpp"

namespace libration::ode {

/// Throws error where the coefficients that are given do not fulfil the equations, or where unknowns have broken
/// powers below a derivative that the equations use. Decided over fractions where the problem has them alone, else by
/// 60 digits, of which 30 have to agree.
void require_consistent_start(const tape& made, const explicit_system& of);

}  // namespace libration::ode
