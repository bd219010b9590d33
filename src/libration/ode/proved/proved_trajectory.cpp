#include "libration/ode/proved/proved_trajectory.hpp"

#include "proving_runs.hpp"

namespace libration::ode {

std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch, const proof_route& route) {
    return proving_runs(system, times, digits, watch, {}, route).result();
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
            require_more_bits(*march, times[each.index], forward);
            return std::nullopt;
        }
        states[each.index] = std::move(*state);
    }
    return states;
}

}  // namespace libration::ode
