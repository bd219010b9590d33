// Proved values of states and of events as answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/solution.hpp"

namespace libration {

struct known_value;
namespace ode {
struct event_report;
struct partial_trajectory;
struct proof_route;
}  // namespace ode

/// With the bound of the decimal or, if no digit is decided, of the value itself.
answer_value value_in_answer(const known_value& value);

/// The states at times, with these names.
answer answer_of(std::vector<std::string> names, const ode::partial_trajectory& found);

/// The events in order: time and the quantities.
answer answer_of(const std::vector<std::string>& quantities, const ode::event_report& found);

/// A search for events with so many digits each.
using event_searcher =
    std::function<ode::event_report(long digits, const ode::proof_route& route, const ode::event_watch& watch)>;

/// The events that a search finds for a request. With request::check each event is compared with one that the search
/// finds by ode::proof_route::second: throws std::runtime_error with both enclosures if they disagree.
answer events_by(const std::vector<std::string>& quantities, const request& how, const ode::event_watch& watch,
                 const event_searcher& search);

}  // namespace libration
