// Events of the solution of a delay differential equation to proved digits.
#pragma once

#include "libration/equation/delay_system.hpp"
#include "libration/query/proved_events.hpp"

namespace libration::ode {

/// As searched_events, by theorems E and M, forwards: g is in the unknowns, their lower derivatives and the variable, and
/// not in delayed values. The slopes of the unknowns are continuous from the initial point on, but not those of neutral
/// equations: throws error of the kind argument for them, and for `before` before the initial point, where the solution
/// is the history.
event_report searched_delay_events(const delay_system& system, const event_request& request, long digits,
                                   const event_watch& watch = {});

}  // namespace libration::ode
