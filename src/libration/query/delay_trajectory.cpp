#include "libration/query/delay_trajectory.hpp"

#include <string>
#include <utility>

#include "../integration/delay/delay_march.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/error.hpp"
#include "time_order.hpp"

namespace libration::ode {

namespace {

std::vector<std::size_t> order_of(const delay_system& system, const std::vector<number>& times) {
    return ascending(times, system.point(), "where the solution is the history");
}

std::string text_of_end(const ball& reached, const std::string& how) {
    return "is not reached: the solution " + how + " up to " + proved_reach_text(reached, true) +
           ", where the step size falls below its minimum (probably a singularity)";
}

}  // namespace

partial_trajectory proved_part_of_delay(const delay_system& system, const std::vector<number>& times, long digits,
                                        const march_watch& watch) {
    const auto order = order_of(system, times);
    const auto names = names_of_state(system);
    partial_trajectory part;
    part.states.resize(times.size());
    part.missing = prove_digits(digits, error_subject::time, [&](const run_bits& run, run_demand& demand) {
        delay_march<ball> march(system, run.bits, watch);
        const precision_scope scope(decimal_digits(run.bits) + 10);
        for (std::size_t i = 0; i < order.size() && !demand.repeats(); ++i) {
            const number& time = times[order[i]];
            if (const auto state = march.at(time)) {
                demand.improve(part.states[order[i]], *state, text_of_time(time), names);
            } else if (march.end() == stop::step_too_small) {
                demand.ended(text_of_time(time), text_of_end(march.reached(), "is proved to exist"));
                return demand.leave_zeros();
            } else {
                demand.ended_part_way(part_of_way(system.point(), march.reached(), times[order.back()]),
                                      text_of_time(time));
            }
        }
        demand.cost(march.steps());
    });
    return part;
}

std::optional<std::vector<std::vector<ball>>> enclosed_delay(const delay_system& system,
                                                             const std::vector<number>& times, long bits) {
    std::vector<std::vector<ball>> states;
    delay_march<ball> march(system, bits);
    for (const number& each : times) {
        auto state = march.at(each);
        if (!state) {
            return std::nullopt;
        }
        states.push_back(*std::move(state));
    }
    return states;
}

template <ordered_scalar T>
partial_states<T> part_of_delay(const delay_system& system, const std::vector<number>& times,
                                const march_watch& watch) {
    partial_states<T> result;
    result.states.assign(times.size(), solution_state<T>(1));
    const auto order = order_of(system, times);
    const auto thrown = undecided_in([&] {
        delay_march<T> march(system, static_cast<long>(digits<T>()), watch);
        for (const std::size_t index : order) {
            const auto state = march.at(times[index]);
            if (!state) {
                result.missing = error(error_kind::undecided, error_subject::time, text_of_time(times[index]),
                                       text_of_end(march.reached(), "is computed"));
                break;
            }
            result.states[index] = {*state};
        }
    });
    result.missing = thrown ? thrown : result.missing;
    return result;
}

template partial_states<double> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<long double> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<quad> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<mpfr> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);

}  // namespace libration::ode
