#include "libration/query/states.hpp"

#include <utility>

#include "libration/equation/dependency.hpp"
#include "proving_runs.hpp"

namespace libration::ode {

namespace {

// Inserts the proved part of an independent system into the whole.
void add_part(partial_trajectory& whole, const partial_trajectory& part, const closed_subsystem& of) {
    for (std::size_t i = 0; i < part.states.size(); ++i) {
        if (part.states[i].empty()) {
            continue;
        }
        whole.states[i].resize(of.leaves_of_whole);
        for (std::size_t k = 0; k < part.states[i].size(); ++k) {
            whole.states[i][of.leaves[k]] = part.states[i][k];
        }
    }
    if (!whole.missing) {
        whole.missing = part.missing;
    }
    whole.collocation.insert(whole.collocation.end(), part.collocation.begin(), part.collocation.end());
}

}  // namespace

partial_trajectory proved_part_of_trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const march_watch& watch, const proof_route& route,
                                             const step_observer& observer, kept_integrations* kept) {
    partial_trajectory whole;
    whole.states.resize(times.size());
    const auto parts = independent_subsystems(system);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const kept_part steps{kept, parts.size() == 1 ? kept_integrations::whole : k};
        add_part(whole, proving_runs(parts[k].system, times, digits, watch, {}, route, observer, steps).part(),
                 parts[k]);
    }
    return whole;
}

std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch, const proof_route& route) {
    return all_digits(proved_part_of_trajectory(system, times, digits, watch, route));
}

std::optional<std::vector<std::vector<ball>>> enclosed_trajectory(const explicit_system& system,
                                                                  const std::vector<number>& times, long bits) {
    std::vector<std::vector<ball>> states(times.size());
    std::optional<proved_march> march;
    bool forward = true;
    for (const asked_time& each : in_order(system, times)) {
        if (!march || each.forward != forward) {
            forward = each.forward;
            march.emplace(system, bits);
        }
        auto state = state_at(*march, system, times[each.index], bits);
        if (!state) {
            if (const auto reason = reason_of_end(*march, system, forward)) {
                throw error(error_kind::undecided, error_subject::time, text_of_time(times[each.index]), *reason);
            }
            return std::nullopt;
        }
        states[each.index] = std::move(*state);
    }
    return states;
}

}  // namespace libration::ode
