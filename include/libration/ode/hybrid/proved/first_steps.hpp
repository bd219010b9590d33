// The values of step functions directly after the initial point.
#pragma once

#include "libration/ode/hybrid/hybrid_system.hpp"

namespace libration::ode {

/// By exact arithmetic on the numbers as typed. Where an argument is 0 at the initial point, its first nonzero
/// derivative on the branch decides. Throws error of the kind undecided unless exactly one branch is possible.
step_values steps_after_start(const hybrid_system& system);

}  // namespace libration::ode
