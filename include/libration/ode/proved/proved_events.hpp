// Events of a solution to proved digits.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "libration/ode/proved/event_search.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// The first `count` zeros of g that are passed in one way, in the open interval behind the start t0: (t0, infinity),
/// or (-infinity, t0) for direction < 0. With from_start also t0 itself where g is 0 there, and first. With `before`
/// those alone that lie certainly before that time or at it. The horizon is that of event_search::next.
struct event_request {
    expression g;
    crossing way = crossing::any;
    long count = 1;
    std::optional<number> before = {};
    int direction = 1;
    bool from_start = false;
    std::optional<long> horizon = {};
};

/// The time and the unknowns with their lower derivatives, in order; an unknown that the event itself gives a value, as
/// x = 0 does, has exactly that.
struct printed_event {
    proved_decimal time;
    std::vector<proved_decimal> values;
};

/// Events that are proved, none left out before the last of them; where they are fewer than were asked for, `missing`
/// says why.
struct event_report {
    std::vector<printed_event> events;
    std::optional<error> missing;
};

/// Told after each step of the integrator and each event: up to which time the present run has come, with how many
/// bits, and the events that are known.
using event_watch = std::function<void(const ball& reached, long bits, const std::vector<printed_event>& known)>;

/// Events with `digits` proved digits each, by runs (event_search.hpp) with more and more bits. `missing`, an error of
/// the kind undecided, where the solution ends before (it says up to where it is proved to exist); where `before` comes
/// first; where the horizon does; where 16 times the first bits, and 4096 of them, do not show whether g is 0, whether
/// the start is an event, or whether an event is before `before`, with the bounds that are proved. Throws other errors.
event_report searched_events(const explicit_system& system, const event_request& request, long digits,
                             const proof_route& route = {}, const event_watch& watch = {});

/// The same, all of them. Throws what is missing.
std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route = {});

}  // namespace libration::ode
