// Solutions that stay at their initial values.
#pragma once

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// Whether the solution is constant: the derivatives given as initial values are 0, and the right-hand sides vanish
/// identically at these values. False if that does not follow by exact arithmetic, and for a singular initial point.
bool is_constant(const explicit_system& system);

}  // namespace libration::ode
