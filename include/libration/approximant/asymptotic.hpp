// Asymptotic approximants: functions whose series at 0 agrees with the given one to its order, and which have the known
// asymptotic behaviour: there f tends to a constant or a line, decays like a power or exponentially, or has a branch
// point.
#pragma once

#include "libration/approximant/branch_approximant.hpp"
#include "libration/approximant/damped_pade.hpp"
#include "libration/approximant/exponential_approximant.hpp"
#include "libration/approximant/power_approximant.hpp"
