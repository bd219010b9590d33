// How many events the solutions of a problem have whose initial values and parameters are in intervals.
//
//     auto orbit = ode::parse("x' = 3*x - 3*x*y; y' = x*y - y; x(0) = [1.288, 1.312]; y(0) = 1");
//     const std::string circle = "(x - 1)^2 + (y - 1)^2 = 0.161^2";
//     ode::event_counts(orbit, {.condition = circle, .before = ode::number(3)}).counts;  // 2, 4
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/query/sets/solution_sets.hpp"

namespace libration::ode {

/// The events between the initial point and the time `before`, which may be before the initial point: the times at which
/// the difference of the two sides of the condition changes its sign, in one direction or in both.
struct event_count_request {
    std::string condition;
    number before;
    crossing way = crossing::any;
    std::size_t most_parts = set_request{}.most_parts;  ///< as set_request
    long digits = set_request{}.digits;
};

struct possible_counts {
    /// In ascending order; empty if they are not decided.
    std::vector<long> counts;
    std::size_t parts = 1;         ///< of the box that were enclosed separately
    long steps = 0;                ///< of all integrations
    std::optional<error> missing;  ///< the reason if they are not decided, of the kind undecided
};

/// For the equations with equation_system::sets: every solution whose initial values and parameters are in these
/// intervals exists up to that time, and has one of these numbers of events; not all of them need occur.
///
/// The solutions of a part of the box are enclosed over short spans of time by theorems V and T. Spans over which the
/// condition may hold make up windows; on each of them, either the derivative of the difference of the sides along the
/// solutions has one sign, so that the difference changes its sign at most once, or its second derivative, then at most
/// twice. Points at which the difference is 0 without changing its sign are not events. Spans are halved and the box is
/// divided where none of these is proved.
///
/// Throws the errors of enclosed_events, and error of the kind argument if `before` is the initial point.
possible_counts event_counts(const equation_system& given, const event_count_request& asked,
                             const march_watch& watch = {}, const proof_route& route = {});

}  // namespace libration::ode
