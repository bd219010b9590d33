// The precision of runs along hybrid solutions, and why they end.
#pragma once

#include <algorithm>
#include <string>

#include "libration/digits/precision_loop.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::ode {

// A path that so many bits do not decide ends.
inline long most_bits_of_path(long digits) { return std::max(1024L, 8 * bits_of_first_run(digits)); }

// "after 3 events, the last one at time 1.5".
inline std::string events_text(const hybrid_path& path) {
    if (path.events() == 0) {
        return "before the first event";
    }
    const std::string count = path.events() == 1
                                  ? "after one event, at time "
                                  : "after " + std::to_string(path.events()) + " events, the last one proved at time ";
    const precision_scope scope(20);
    return count + to_decimal(midpoint_of(path.last_event()), 12);
}

// What the end of a path needs: more bits, if they may help.
inline void demand_of_path(run_demand& demand, const hybrid_path& path, long digits, const std::string& of) {
    const auto reason = [&] { return "is not reached: " + events_text(path) + ", " + path.reason(); };
    switch (path.end()) {
        case path_end::none:
        case path_end::precision: demand.twice_the_bits(of); break;
        case path_end::undecided: demand.undecided(of, reason(), most_bits_of_path(digits)); break;
        case path_end::time:
        case path_end::horizon:
        case path_end::stop:
        case path_end::steps:
        case path_end::sliding:
        case path_end::accumulation: demand.ended(of, reason()); break;
    }
}

}  // namespace libration::ode
