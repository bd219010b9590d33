#include "smooth_equations.hpp"

#include <string>

namespace libration::ode {

void require_smooth_equations(const equation_system& given) {
    const std::string reason =
        ", which only reference, trajectory and verify support, without a certificate: leave it out";
    if (!given.events.empty()) {
        refuse(given.events.front().text, given.events.front().at, "is an event" + reason);
    }
    if (!given.steps.empty()) {
        refuse(given.steps.front().text, given.steps.front().at, "is piecewise" + reason);
    }
    const std::string of_values =
        ", which is supported for values at times (reference, trajectory) alone: leave it out";
    if (!given.delays.empty()) {
        const delayed_value& first = given.delays.front();
        refuse(primed(first.of.name(), first.of.derivative()), first.at, "is delayed" + of_values);
    }
    if (!given.histories.empty()) {
        refuse(given.histories.front().unknown, given.histories.front().at, "has a history" + of_values);
    }
}

}  // namespace libration::ode
