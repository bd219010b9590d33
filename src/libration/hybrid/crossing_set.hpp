// The set of solutions after an event, from that of the step on which it is.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/integration/step.hpp"

namespace libration::ode {

/// A crossing of g = 0, or a known time, in expressions in the leaves of the system and the variable. The event of every
/// solution through the set of the step is in the ball of times.
struct set_crossing {
    const first_order_form& before;        ///< the equations before the event
    const first_order_form& after;         ///< and after it
    const std::vector<expression>& reset;  ///< the leaves after it in terms of their values before
    const expression* g;                   ///< null at a known time
    const ball& time;                      ///< the ball
    const ball& begin;                     ///< its lower end, exact, or the known time
    const std::vector<ball>& state_after;  ///< the states after the event
    const std::vector<ball>& around;       ///< and of the next branch at all times of the ball
};

/// The set at `begin` of the solutions of the next branch (theorem H, 5); std::nullopt if the event is not on one step of
/// Taylor series, or a value or a derivative is not enclosed.
std::optional<state_set> set_after_crossing(const step& here, const set_crossing& at);

}  // namespace libration::ode
