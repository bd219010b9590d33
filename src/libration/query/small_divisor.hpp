// What is nearly 0 where an integration ends.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// "there |x - 1| <= 1.3e-12": the smallest of the divisors, arguments of logarithms and bases of powers that are not whole in
/// the right-hand sides, at a state of the given unknowns; empty where all may be at least 10^-3, or the text is long.
std::string small_divisor_text(const explicit_system& system, const ball& time, const std::vector<ball>& state);

}  // namespace libration::ode
