// Multiples of a motion's period as decimals.
#pragma once

#include <string>
#include <vector>

#include "libration/pendulum/motion.hpp"

namespace libration::pendulum {

/// Times that contain a multiple of T, in the motion's unit, to `digits` digits, each proved. T is computed once for
/// all. Throws error at E = 2, where T is infinite, and of the kind undecided if a digit is not decided.
std::vector<std::string> proved_times(const motion& m, const std::vector<exact>& times, long digits);

}  // namespace libration::pendulum
