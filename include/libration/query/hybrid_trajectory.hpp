// Values and events of hybrid systems to proved digits.
#pragma once

#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// The unknowns, their lower derivatives and the expressions to show at times from the initial point on, in any order:
/// `digits` significant digits each, proved (hybrid_path, in runs with increasing precision). At the time of an event the values after it.
/// `missing` is an error of the kind undecided where a path ends before a time: at an event that ends the solution,
/// where it slides, where events accumulate, near a singularity, and where 8 times the first bits, and 1024 of them, do
/// not decide which event is next; the message contains the number of events before and their last time. A value that
/// jumps at a time that is not distinguished from that of an event has no decimal. Throws error of the kind argument for
/// times before the initial point.
partial_trajectory proved_part_of_hybrid(const hybrid_system& system, const std::vector<number>& times, long digits,
                                         const march_watch& watch = {}, const proof_route& route = {});

/// A branch of the solution: a smooth system from a point within the precision of the time of its event.
struct hybrid_branch {
    explicit_system system;
    step_values steps;
    std::vector<std::size_t> times;  ///< the indices of the times on it
};

/// The branches on which times lie, for integration in arithmetic that rounds; `digits` are those of their initial
/// values, which are correct to about that number of digits.
struct hybrid_branches {
    std::vector<hybrid_branch> branches;
    std::optional<error> missing;
};
hybrid_branches branches_at_times(const hybrid_system& system, const std::vector<number>& times, long digits);

/// The zeros of a function along the solution, forwards: as searched_events, whose errors it throws. The values of an
/// event at which the solution jumps are those before it.
event_report searched_hybrid_events(const hybrid_system& system, const event_request& request, long digits,
                                    const proof_route& route = {}, const event_watch& watch = {});

}  // namespace libration::ode
