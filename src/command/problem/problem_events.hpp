// The events of a problem as a table; the search shows progress and can be interrupted.
#pragma once

#include <functional>

#include "libration/query/proved_events.hpp"
#include "solution_table.hpp"

namespace libration {

/// The events of a solution (events_table), the first event in the first row; progress on a terminal. A signal that ends
/// the process meanwhile (run/ending_signal.hpp) writes the known events by `write`, unless there are none, reports on
/// stderr the time reached, and ends the process with exit code 1.
partial_table problem_events(const solution& of, const ode::explicit_system& system, const ode::event_request& request,
                             const libration::request& how, const std::function<void(const partial_table&)>& write);

}  // namespace libration
