// A table of motions at times: theta, omega and the constants of each motion with proved digits, and how well
// conditioned they are.
#pragma once

#include "libration/number/exact.hpp"
#include "option/option_words.hpp"
#include "text/table.hpp"

namespace libration {

/// How typed numbers are written to a table: as typed, or as decimals, which every reader of numbers accepts.
enum class input_style { typed, decimals };

/// The digits that a typed number has more than the results where no decimal holds it (pi/3, T/8, 1/3).
inline constexpr long more_input_digits = 10;

/// A number as a decimal: exactly where there is one, else with so many proved digits.
std::string decimal_text(const exact& number, long digits);

/// Every motion at every time, in the order in which they were typed, --energies before --gaps. The columns are
/// energy, gap, theta0, omega0 and direction (these three where they were given), time, theta, omega, period, tstar,
/// radius, condition, and, in the typed style, digits and rigour.
///
/// condition = (|t omega| + sum |x dtheta/dx|)/max(1, |theta|) over the numbers x that give the motion: what verify
/// prints, by conditioned_motion, to three digits and heuristic; everything else is proved. Throws input_error.
table motion_table(const option_words& said, long digits, input_style style, int jobs);

}  // namespace libration
