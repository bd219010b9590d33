// Equations without events, step functions and delays.
#pragma once

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Throws error for events and step functions, which need a sequence of smooth systems (hybrid/hybrid_system.hpp), and
/// for delays, which need a sequence of pieces (delay/delay_system.hpp).
void require_smooth_equations(const equation_system& given);

}  // namespace libration::ode
