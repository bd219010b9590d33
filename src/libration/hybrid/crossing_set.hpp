// The set of solutions after an event, from that of the step on which it is.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/integration/step.hpp"

namespace libration::ode {

/// A crossing of g = 0, or a known time, in expressions in the leaves of the system and the variable.
struct set_crossing {
    const first_order_form& before;        ///< the equations before the event
    const first_order_form& after;         ///< and after it
    const std::vector<expression>& reset;  ///< the leaves after it in terms of their values before
    const expression* g;                   ///< null at a known time
    const ball& time;                      ///< a ball that contains that of the event
    const ball& begin;                     ///< its lower end, exact, or the known time
};

/// The set at `begin` of the solutions of the next branch (theorem H, 5); std::nullopt if the event is not on one step of
/// Taylor series, if it is not proved that every solution through the set of this step has it in twice the ball of times,
/// as the proof requires, or if a value or a derivative is not enclosed.
std::optional<state_set> set_after_crossing(const step& here, const set_crossing& at);

}  // namespace libration::ode
