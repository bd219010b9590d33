#include "libration/query/shooting/proved_unknowns.hpp"

#include "shooting.hpp"

namespace libration::ode {

std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const conditions_at_times& conditions, long digits,
                                            const proof_route& route, const march_watch& watch) {
    const shooting shots(system, names, conditions, route, watch);
    return proved_root(
        [&](const std::vector<ball>& x, long bits, long error_bits) { return shots(x, bits, error_bits); },
        first_iterate(shots.guess()), digits, names);
}

std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits,
                                            const proof_route& route, const march_watch& watch) {
    conditions_at_times all;
    for (const point_condition& each : conditions) {
        all.add(all.at(unknown(each.unknown, each.derivative), expression(each.time)) - expression(each.value));
    }
    return proved_unknowns(system, names, all, digits, route, watch);
}

}  // namespace libration::ode
