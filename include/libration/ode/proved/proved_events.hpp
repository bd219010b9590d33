// Events of a solution to proved digits.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/proved/event_search.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// The first `count` zeros of g after the start that are passed in one way, none beyond `before`.
struct event_request {
    expression g;
    crossing way = crossing::any;
    long count = 1;
    std::optional<number> before = {};
    int direction = 1;
};

/// The time and the unknowns with their lower derivatives, in order; an unknown that the event itself gives a value, as
/// x = 0 does, has exactly that.
struct printed_event {
    proved_decimal time;
    std::vector<proved_decimal> values;
};

/// Events with `digits` proved digits each. Throws error of the kind undecided where the solution ends before (it says
/// up to where it exists), where `before` comes first, and where more bits do not tell a touching zero from none.
std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route = {});

}  // namespace libration::ode
