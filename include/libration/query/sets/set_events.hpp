// Enclosures of the events of all solutions of a problem whose initial values and parameters are in intervals.
//
//     auto fall = ode::parse("y'' = -g; y(0) = [0.9, 1.1]; y'(0) = 0; g = [9.7, 9.9]");
//     ode::enclosed_events(fall, {.condition = "y = 0"}).events[0].time.lower;  // sqrt(2*0.9/9.9) or less
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/event/zero_search.hpp"
#include "libration/query/sets/solution_sets.hpp"

namespace libration::ode {

/// The first `count` events of each solution after the initial point: zeros of the difference of the two sides of the
/// condition that are crossed in one direction. The condition is in unknowns, lower derivatives, the variable and
/// parameters, which may be sets. With `before` only those before or at that time, which may be before the initial
/// point; the horizon is that of zero_search::next.
struct set_event_request {
    std::string condition;
    crossing way = crossing::any;
    long count = 1;
    std::optional<number> before = {};
    std::optional<long> horizon = {};
    std::size_t most_parts = set_request{}.most_parts;  ///< as set_request
    long digits = set_request{}.digits;
};

/// Bounds of the time and of the unknowns then, in the order of set_events::names.
struct enclosed_event {
    closed_interval time;
    std::vector<closed_interval> values;
};

/// Event k of every solution of the set.
struct set_events {
    std::vector<std::string> names;  ///< the unknowns and their lower derivatives: x, x', ...
    std::vector<enclosed_event> events;
    std::size_t parts = 1;         ///< of the box that were enclosed separately
    long steps = 0;                ///< of all integrations
    std::size_t faces = 0;         ///< of the box from which bounds of monotone values were taken
    std::optional<error> missing;  ///< the reason if there are fewer events than requested, of the kind undecided
};

/// For the equations with equation_system::sets: every solution whose initial values and parameters are in these
/// intervals exists up to its event k, which is a simple zero, and has its time and its unknowns then in the intervals of
/// that event. A system without sets has one solution.
///
/// As enclosed_solutions, with the zeros of theorem E on the enclosures of all solutions of a part: all of them cross the
/// surface of the condition in the same way, at times in an interval. The derivatives of the time and the unknowns with
/// respect to the numbers of the box are those of the implicit function. Throws the errors of both.
set_events enclosed_events(const equation_system& given, const set_event_request& asked, const march_watch& watch = {},
                           const proof_route& route = {});

}  // namespace libration::ode
