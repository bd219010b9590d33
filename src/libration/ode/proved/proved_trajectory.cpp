#include "libration/ode/proved/proved_trajectory.hpp"

#include <utility>

#include "libration/ode/dependency.hpp"
#include "proving_runs.hpp"

namespace libration::ode {

namespace {

// What was proved of independent systems, as that of the whole: a time that one of them does not reach is not reached.
class joined_parts {
public:
    explicit joined_parts(std::size_t times) : reached_(times, true) { whole_.states.resize(times); }

    void add(const partial_trajectory& part, const closed_subsystem& of) {
        for (std::size_t i = 0; i < reached_.size(); ++i) {
            reached_[i] = reached_[i] && !part.states[i].empty();
            whole_.states[i].resize(of.leaves_of_whole);
            for (std::size_t k = 0; k < part.states[i].size(); ++k) {
                whole_.states[i][of.leaves[k]] = part.states[i][k];
            }
        }
        if (!whole_.missing) {
            whole_.missing = part.missing;
        }
    }

    partial_trajectory result() {
        for (std::size_t i = 0; i < reached_.size(); ++i) {
            if (!reached_[i]) {
                whole_.states[i].clear();
            }
        }
        return std::move(whole_);
    }

private:
    std::vector<bool> reached_;
    partial_trajectory whole_;
};

}  // namespace

partial_trajectory proved_part_of_trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const march_watch& watch, const proof_route& route) {
    joined_parts parts(times.size());
    for (const closed_subsystem& each : independent_subsystems(system)) {
        parts.add(proving_runs(each.system, times, digits, watch, {}, route).part(), each);
    }
    return parts.result();
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
            require_more_bits(*march, times[each.index], forward);
            return std::nullopt;
        }
        states[each.index] = std::move(*state);
    }
    return states;
}

}  // namespace libration::ode
