// Limits of an orbit from an equilibrium to itself.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The conditions x(-inf) = v, x(inf) = v for all unknowns and lower derivatives x of an autonomous system: v is the zero of the right-hand
/// sides to which Newton's method in double leads from the initial values, as fractions with a denominator of at most 1000. That it is one
/// is proved by far_state_of(). Throws error of the subject "problem" if there is none, or if it is not seen to be such fractions.
std::vector<std::string> homoclinic_limits(const explicit_system& system);

}  // namespace libration::ode
