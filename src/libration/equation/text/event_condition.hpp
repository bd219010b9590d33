// What the condition of `when` means as an event.
#pragma once

#include <vector>

#include "condition.hpp"
#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// The events of `when condition: ...`, each like the given one, in its direction, otherwise:
///   - a = b and a == b: where a - b crosses 0. With values that resets alone change, and with step functions alone: where
///     the condition begins to hold. mod(u, c) = r with u = b t + d and constants b, c, d, r: whenever u is r plus a
///     multiple of c, which is where mod(u - r, c) < c/2, for b < 0 mod(r - u, c) < c/2, begins to hold.
///   - a > b: where a - b crosses 0 upwards, if that is smooth, and else where it begins to hold.
///   - c or d with equations among the alternatives: an event of each, of which one happens at a time.
///   - others: where they begin to hold.
/// Throws error for a direction of another condition than a = b, for an equation in the variable alone that `and` joins,
/// which holds at moments, and for other equations with step functions.
std::vector<state_event> events_when(const condition& holds, const state_event& like, equation_system& into);

}  // namespace libration::ode
