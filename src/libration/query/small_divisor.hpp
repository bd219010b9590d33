// What is nearly 0 where an integration ends.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// "there |x - 1| <= 1.3e-12": the smallest of the divisors, arguments of logarithms and bases of powers that are not whole in
/// the right-hand sides, at a state of the given unknowns; empty where all may be at least 10^-3, or the text is long. Of a
/// root also what to write for a store that remains empty; of a quotient whose numerator is about 0, too, why the solution
/// does not cross this place.
std::string small_divisor_text(const explicit_system& system, const ball& time, const std::vector<ball>& state);

/// Whether a node is a root or another positive power that is not whole, which has no real value where its argument is negative.
bool has_no_value_below_zero(const expression& e);

}  // namespace libration::ode
