#include "libration/query/hybrid_trajectory.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "../hybrid/path_limits.hpp"
#include "exact_zeros.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "shown_values.hpp"
#include "time_order.hpp"

namespace libration::ode {

namespace {

std::vector<std::size_t> order_of(const hybrid_system& system, const std::vector<number>& times) {
    return ascending(times, system.point(),
                     "from which events and piecewise right-hand sides are followed forwards only");
}

// At the time of an event that is not distinguished from this one, step functions have values on both sides.
void append_shown_at(std::vector<ball>& state, const hybrid_path& path, const hybrid_system& system,
                     const number& time) {
    append_shown(state, system, path.piece().system, path.piece().steps, ball(constant_value<ball>::of(time)),
                 [&](expression_values<ball>& values, const expression& on_branch) {
                     ball value = values.of(on_branch);
                     if (path.at_event()) {
                         arb_zero_pm_inf(value.handle());
                     }
                     return value;
                 });
}

// A value at an event that is less than so many times the digits is taken for 0.
constexpr long times_digits_of_zero = 3;

// The values at the time of an event, which are on both sides of it. False if this time is left open: a value that does
// not become narrower jumps there, or is 0.
bool improve_at_event(run_demand& demand, std::vector<known_value>& kept, const std::vector<ball>& now, long digits,
                      const std::string& time, const std::vector<std::string>& names, std::size_t shown) {
    kept.resize(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
        improve(kept[k], now[k], digits);
        if (!kept[k].decimal) {
            const std::string reason = "is not distinguished from the time of an event by " +
                                       std::to_string(demand.now().bits) + " bits, " +
                                       (is_finite(now[k])         ? "about which a value is in " + bounds_text(now[k])
                                        : k >= now.size() - shown ? "about which " + names[k] + " is not bounded"
                                                                  : "at which derivatives may not exist");
            const bool is_zero = is_finite(now[k]) && contains_zero(now[k]) &&
                                 magnitude(now[k]) < magnitude::of(1, -times_digits_of_zero * bits_of_digits(digits));
            is_zero ? demand.ended(time, reason) : demand.undecided(time, reason, most_bits_of_path(digits));
        }
    }
    return demand.repeats() || all_have_digits(kept);
}

// The values on a branch; an expression to show without one does not take the others with it.
void improve_on_branch(run_demand& demand, std::vector<known_value>& kept, const std::vector<ball>& now,
                       const std::string& time, const std::vector<std::string>& names, const hybrid_system& system,
                       const path_piece& piece) {
    kept.resize(now.size());
    const std::size_t first = now.size() - system.shown().size();
    for (std::size_t k = 0; k < now.size(); ++k) {
        const auto none = k < first || is_finite(now[k])
                              ? std::nullopt
                              : reason_without_value(system.shown()[k - first], system, piece.system, piece.steps, now);
        none ? demand.ended(time, *none) : demand.improve(kept[k], now[k], time, names[k]);
    }
}

// Which leaves have equations without step functions, and are not reset, nor is what influences them.
std::vector<bool> leaves_without_steps(const hybrid_system& system) {
    std::vector<bool> free;
    for (const expression& leaf : system.leaves()) {
        free.push_back(system.events().empty() &&
                       std::ranges::none_of(system.influences_on(leaf), [](bool each) { return each; }));
    }
    return free;
}

}  // namespace

partial_trajectory proved_part_of_hybrid(const hybrid_system& system, const std::vector<number>& times, long digits,
                                         const march_watch& watch, const proof_route& route) {
    const auto order = order_of(system, times);
    const auto names = names_with_shown(system);
    std::optional<exact_zeros> zeros;
    const std::vector<bool> free = leaves_without_steps(system);
    std::vector<bool> left_open(times.size());
    partial_trajectory part;
    part.states.resize(times.size());
    part.missing = prove_digits(digits, error_subject::time, [&](const run_bits& run, run_demand& demand) {
        hybrid_path path(system, run.bits, route, watch);
        const precision_scope scope(decimal_digits(run.bits) + 10);
        if (!zeros) {
            zeros.emplace(path.piece().system);
        }
        for (std::size_t i = 0; i < order.size() && !demand.repeats(); ++i) {
            const std::size_t index = order[i];
            auto state = path.at(times[index], times[order.back()]);
            part.by_relation = path.by_relation();
            if (!state) {
                demand_of_path(demand, path, digits, text_of_time(times[index]));
                return demand.leave_zeros();
            }
            if (left_open[index]) {
                continue;
            }
            zeros->put(*state, times[index], free);
            append_shown_at(*state, path, system, times[index]);
            if (path.at_event()) {
                left_open[index] = !improve_at_event(demand, part.states[index], *state, digits,
                                                     text_of_time(times[index]), names, system.shown().size());
            } else {
                improve_on_branch(demand, part.states[index], *state, text_of_time(times[index]), names, system,
                                  path.piece());
            }
        }
        demand.cost(path.steps());
    });
    return part;
}

hybrid_branches branches_at_times(const hybrid_system& system, const std::vector<number>& times, long digits) {
    const auto order = order_of(system, times);
    hybrid_branches found;
    found.missing = prove_digits(digits, error_subject::time, [&](const run_bits& run, run_demand& demand) {
        found.branches.clear();
        hybrid_path path(system, run.bits);
        long events = -1;
        for (const std::size_t index : order) {
            if (!path.at(times[index], times[order.back()])) {
                return demand_of_path(demand, path, digits, text_of_time(times[index]));
            }
            if (path.events() != events) {
                events = path.events();
                found.branches.push_back({path.piece().system, path.piece().steps, {}});
            }
            found.branches.back().times.push_back(index);
        }
    });
    return found;
}

}  // namespace libration::ode
