#include "libration/query/delay_trajectory.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "../equation/needed_bits.hpp"
#include "../integration/delay/delay_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Ascending.
std::vector<std::size_t> order_of(const delay_system& system, const std::vector<number>& times) {
    for (const number& each : times) {
        if ((each - system.point()).sign() < 0) {
            throw error(error_kind::argument, "time", text_of_time(each),
                        "is before the initial point, where the solution is the history: choose times after it");
        }
    }
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return (times[a] - times[b]).sign() < 0; });
    return order;
}

error not_reached(const number& time, const ball& reached, const std::string& how) {
    return {error_kind::undecided, "time", text_of_time(time),
            "is not reached: the solution " + how + " up to " + proved_reach_text(reached, true) +
                ", where the steps become too small, as they do near a singularity"};
}

class delay_runs {
public:
    delay_runs(const delay_system& system, const std::vector<number>& times, long digits, const march_watch& watch)
        : system_(system),
          times_(times),
          order_(order_of(system, times)),
          digits_(digits),
          watch_(watch),
          bits_(digits) {
        part_.states.resize(times.size());
    }

    partial_trajectory part() {
        try {
            while (!complete()) {
            }
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            part_.missing = part_.missing.value_or(problem);
        }
        return std::move(part_);
    }

private:
    bool complete() {
        delay_march<ball> march(system_, bits_.now(), watch_);
        const precision_scope scope(decimal_digits(bits_.now()) + 10);
        std::optional<std::size_t> at_zero;
        for (const std::size_t index : order_) {
            const auto state = march.at(times_[index]);
            if (!state) {
                if (march.end() == stop::step_too_small) {
                    throw not_reached(times_[index], march.reached(), "is proved to exist");
                }
                bits_.raise_to(bits_to_go_on(march.reached()), "time", text_of_time(times_[index]));
                return false;
            }
            if (!proved(index, *state)) {
                return false;
            }
            if (!all_have_digits(part_.states[index])) {
                at_zero = at_zero.value_or(index);
            }
        }
        return !at_zero || given_up(*at_zero, march.steps());
    }

    // The digits of the values, or bounds; false if one that excludes 0 needs more bits.
    bool proved(std::size_t index, const std::vector<ball>& values) {
        auto& state = part_.states[index];
        state.resize(values.size());
        const ball* too_wide = nullptr;
        for (std::size_t k = 0; k < values.size(); ++k) {
            improve(state[k], values[k], digits_);
            if (!state[k].decimal && !contains_zero(values[k])) {
                too_wide = &values[k];
            }
        }
        if (too_wide != nullptr) {
            bits_.raise_for(*too_wide, "time", text_of_time(times_[index]));
        }
        return too_wide == nullptr;
    }

    bool given_up(std::size_t index, long steps) {
        if (bits_.raised_at_zero(steps, "time", text_of_time(times_[index]))) {
            return false;
        }
        part_.missing = error(error_kind::undecided, "time", text_of_time(times_[index]),
                              text_of_undecided(names_of_state(system_), part_.states[index], bits_.now()));
        return true;
    }

    // The bits lost up to here, extrapolated to the last time, and a margin.
    long bits_to_go_on(const ball& reached) const {
        constexpr double largest_growth = 6;
        const precision_scope scope(20);
        const double gone = rough_value(reached - constant_value<ball>::of(system_.point()));
        const double whole = rough_value(constant_value<ball>::of(times_[order_.back()] - system_.point()));
        const double growth = gone > 0 ? std::min(whole / gone * 21 / 20, largest_growth) : largest_growth;
        return std::max(bits_.now() + bits_.now() / 4,
                        static_cast<long>(growth * static_cast<double>(bits_.now())) + bits_of_digits(digits_));
    }

    const delay_system& system_;
    const std::vector<number>& times_;
    std::vector<std::size_t> order_;
    long digits_;
    const march_watch& watch_;
    partial_trajectory part_;
    needed_bits bits_;
};

}  // namespace

partial_trajectory proved_part_of_delay(const delay_system& system, const std::vector<number>& times, long digits,
                                        const march_watch& watch) {
    return delay_runs(system, times, digits, watch).part();
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
    try {
        delay_march<T> march(system, static_cast<long>(digits<T>()), watch);
        for (const std::size_t index : order) {
            const auto state = march.at(times[index]);
            if (!state) {
                throw not_reached(times[index], march.reached(), "is computed");
            }
            result.states[index] = {*state};
        }
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        result.missing = problem;
    }
    return result;
}

template partial_states<double> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<long double> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<quad> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);
template partial_states<mpfr> part_of_delay(const delay_system&, const std::vector<number>&, const march_watch&);

}  // namespace libration::ode
