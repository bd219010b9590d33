// The arguments of the rounded and the proved digits of a motion, parsed exactly.
#pragma once

#include <optional>
#include <string>

#include "libration/pendulum/arc_method.hpp"
#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/given_motion.hpp"
#include "libration/pendulum/motion.hpp"

namespace libration::pendulum {

/// Throws error of the kind argument for a multiple of an infinite period.
void require_time(const motion& m, const exact& time);

/// A time of this motion; throws error of the kind argument for an angle and for a multiple of an infinite period.
exact exact_time(const motion& m, const std::string& text);

/// The decimal of E or 2 - E if it terminates within this many digits: exact, without computation.
std::optional<std::string> short_decimal(const std::optional<rational>& value, long digits);

/// The point of an expansion and its power; throws error of the kind argument.
expansion_point exact_point(const motion& m, const std::string& point, long n);

/// The energy of a motion for which the error norm is defined; throws error of the kind argument for E = 0 and 2, for
/// one that is not rational, and for an order below 0.
rational energy_of_norm(const motion& m, int order);

}  // namespace libration::pendulum
