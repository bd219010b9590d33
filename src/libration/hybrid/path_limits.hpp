// The precision of runs along hybrid solutions, and why they end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "../equation/needed_bits.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

// A path that so many bits do not decide ends.
inline long most_bits_of_undecided(const needed_bits& first) { return std::max(1024L, 8 * first.now()); }

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

// Why more bits do not help at the end of a path; std::nullopt if they may.
inline std::optional<std::string> reason_of_end(const hybrid_path& path, long most_undecided) {
    switch (path.end()) {
        case path_end::none:
        case path_end::precision: return std::nullopt;
        case path_end::undecided:
            if (2 * path.bits() <= most_undecided) {
                return std::nullopt;
            }
            break;
        case path_end::time:
        case path_end::horizon:
        case path_end::stop:
        case path_end::steps:
        case path_end::sliding:
        case path_end::accumulation: break;
    }
    return "is not reached: " + events_text(path) + ", " + path.reason();
}

// The bits of the next run of a path that ended; throws if more bits do not help.
inline void raise_path_bits(needed_bits& bits, const hybrid_path& path, long most_undecided, const std::string& subject,
                            const std::string& value) {
    if (const auto reason = reason_of_end(path, most_undecided)) {
        throw error(error_kind::undecided, subject, value, *reason);
    }
    bits.raise_to(2 * bits.now(), subject, value);
}

}  // namespace libration::ode
