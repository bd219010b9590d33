// Asymptotic approximants: functions whose series at 0 is the given one as far as it goes, and which behave far away as
// is known: f there tends to a constant or a line, decays like a power or exponentially, or has a branch point.
#pragma once

#include "libration/approximant/asymptotic/branch_approximant.hpp"
#include "libration/approximant/asymptotic/damped_pade.hpp"
#include "libration/approximant/asymptotic/exponential_approximant.hpp"
#include "libration/approximant/asymptotic/power_approximant.hpp"
