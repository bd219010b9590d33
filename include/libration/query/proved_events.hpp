// Events of a solution to proved digits.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

using libration::known_value;

/// The first `count` zeros of g that are crossed in one direction, in the open interval after the initial point t0:
/// (t0, infinity), or (-infinity, t0) for direction < 0. With from_start also t0 itself, as the first one, if g is 0
/// there. With `before` only those that are certainly before that time or at it. The horizon is that of
/// zero_search::next.
struct event_request {
    expression g;
    crossing way = crossing::any;
    long count = 1;
    std::optional<number> before = {};
    int direction = 1;
    bool from_start = false;
    std::optional<long> horizon = {};
};

/// The time and the unknowns with their lower derivatives, in order; an unknown whose value is fixed by the event
/// itself, as by x = 0, has exactly that value.
struct printed_event {
    proved_decimal time;
    std::vector<proved_decimal> values;
};

/// The same as far as it is proved: a number that no run within the limits distinguishes from 0 has only a bound.
struct known_event {
    known_value time;
    std::vector<known_value> values;

    /// Whether every number has its digits.
    bool is_complete() const { return time.decimal && all_have_digits(values); }
};

/// Proved events, including all before the last of them.
struct event_report {
    std::vector<known_event> events;
    /// The reason if there are fewer than requested, or else if a number of one has no digits: an error of the kind
    /// undecided.
    std::optional<error> missing;
    /// Where the last run used collocation, if it did.
    std::vector<collocation_use> collocation = {};
    /// hybrid_path::by_relation.
    std::vector<std::string> by_relation = {};
};

/// Called after each step of the integrator and each event with the time that the current run has reached, its bits,
/// and the events found so far.
using event_watch = std::function<void(const ball& reached, long bits, const std::vector<known_event>& known)>;

/// Events with `digits` proved digits each, by runs (zero_search.hpp) with increasing precision. They are fewer than
/// requested if the solution ends before (`missing` has the time up to which it is proved to exist); if `before` comes
/// first; if the horizon does; if 16 times the first bits, and 4096 of them, do not determine whether g is 0, whether
/// the initial point is an event, or whether an event is before `before` (`missing` has the proved bounds). A number
/// that is not distinguished from 0 does not affect the others. Throws other errors. With kept steps of the system they
/// are searched first.
event_report searched_events(const explicit_system& system, const event_request& request, long digits,
                             const proof_route& route = {}, const event_watch& watch = {},
                             kept_integrations* kept = nullptr);

/// The same with all requested events and all their digits; throws `missing` otherwise.
std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route = {});

}  // namespace libration::ode
