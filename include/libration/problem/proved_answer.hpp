// Proved values of states and of events as answers.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/answer.hpp"

namespace libration {

namespace ode {
struct event_report;
struct known_value;
struct partial_trajectory;
}  // namespace ode

/// With the bound of the decimal or, if no digit is decided, of the value itself.
answer_value value_in_answer(const ode::known_value& value);

/// The states at times, with these names.
answer answer_of(std::vector<std::string> names, const ode::partial_trajectory& found);

/// The events in order: time and the quantities.
answer answer_of(const std::vector<std::string>& quantities, const ode::event_report& found);

}  // namespace libration
