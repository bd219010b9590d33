// The events of a problem as a table; the search shows progress and can be interrupted.
#pragma once

#include <functional>

#include "equation/solution_table.hpp"
#include "libration/query/proved_events.hpp"

namespace libration {

/// ode::searched_events of a smooth system, ode::searched_hybrid_events of another one.
using event_searcher = std::function<ode::event_report(const ode::event_request& request, long digits,
                                                       const ode::proof_route& route, const ode::event_watch& watch)>;

/// The events found by `search` (events_table), the first event in the first row; progress on a terminal. A signal that
/// ends the process meanwhile (run/ending_signal.hpp) writes the known events by `write`, unless there are none, reports
/// on stderr the time reached, and ends the process with exit code 1. With `check` each event is compared with a second
/// proof (ode::proof_route::second): throws std::runtime_error with both enclosures if they disagree.
partial_table problem_events(const ode::explicit_system& system, const ode::event_request& request, long digits,
                             const ode::proof_route& route, bool check, const event_searcher& search,
                             const std::function<void(const partial_table&)>& write);

}  // namespace libration
