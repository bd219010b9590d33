#include "libration/query/hybrid_trajectory.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "../equation/needed_bits.hpp"
#include "../hybrid/path_limits.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Ascending.
std::vector<std::size_t> in_order(const hybrid_system& system, const std::vector<number>& times) {
    const precision_scope scope(40);
    std::vector<mpfr> gone;
    for (const number& each : times) {
        gone.push_back(constant_value<mpfr>::of(each - system.point()));
        if (gone.back() < 0) {
            throw error(error_kind::argument, "time", text_of_time(each),
                        "is before the initial point, from which events and piecewise right-hand sides are followed "
                        "forwards only: choose times after it");
        }
    }
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Times that are not distinguished by the digits of `gone` are compared exactly.
    const mpfr doubt = ldexp(mpfr(1), -100);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const mpfr difference = gone[a] - gone[b];
        return abs(difference) > doubt * (gone[a] + gone[b]) ? difference < 0 : (times[a] - times[b]).sign() < 0;
    });
    return order;
}

class hybrid_runs {
public:
    hybrid_runs(const hybrid_system& system, const std::vector<number>& times, long digits, const march_watch& watch,
                const proof_route& route)
        : system_(system),
          times_(times),
          order_(in_order(system, times)),
          digits_(digits),
          watch_(watch),
          route_(route),
          bits_(digits),
          most_undecided_(most_bits_of_undecided(bits_)) {
        part_.states.resize(times.size());
        done_.resize(times.size());
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
        hybrid_path path(system_, bits_.now(), route_, watch_);
        const precision_scope scope(decimal_digits(bits_.now()) + 10);
        std::optional<std::size_t> at_zero;
        for (const std::size_t index : order_) {
            const auto state = path.at(times_[index], times_[order_.back()]);
            part_.by_relation = path.by_relation();
            if (!state) {
                raise_path_bits(bits_, path, most_undecided_, "time", text_of_time(times_[index]));
                return false;
            }
            if (done_[index]) {
                continue;
            }
            if (!proved(index, *state, path.at_event())) {
                return false;
            }
            if (!all_have_digits(part_.states[index]) && !done_[index]) {
                at_zero = at_zero.value_or(index);
            }
        }
        return !at_zero || given_up(*at_zero, path.steps());
    }

    // The digits of the values, or bounds; false if one that excludes 0 needs more bits.
    bool proved(std::size_t index, const std::vector<ball>& values, bool at_event) {
        auto& state = part_.states[index];
        state.resize(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (state[k].decimal) {
                continue;
            }
            improve(state[k], values[k], digits_);
            if (!state[k].decimal && at_event && 2 * bits_.now() > most_undecided_) {
                jumps(index, values[k]);
            } else if (!state[k].decimal && (at_event || !contains_zero(values[k]))) {
                at_event ? bits_.raise_to(2 * bits_.now(), "time", text_of_time(times_[index]))
                         : bits_.raise_for(values[k], "time", text_of_time(times_[index]));
                return false;
            }
        }
        return true;
    }

    // A value that does not become narrower jumps at this very time, or is 0.
    void jumps(std::size_t index, const ball& value) {
        done_[index] = true;
        if (!part_.missing) {
            const std::string where = is_finite(value) ? "about which a value is in " + bounds_text(value)
                                                       : "at which derivatives may not exist";
            part_.missing = error(
                error_kind::undecided, "time", text_of_time(times_[index]),
                "is not distinguished from the time of an event by " + std::to_string(bits_.now()) + " bits, " + where);
        }
    }

    bool given_up(std::size_t index, long steps) {
        if (bits_.raised_at_zero(steps, "time", text_of_time(times_[index]))) {
            return false;
        }
        part_.missing = error(error_kind::undecided, "time", text_of_time(times_[index]),
                              text_of_undecided(names_of_state(system_), part_.states[index], bits_.now()));
        return true;
    }

    const hybrid_system& system_;
    const std::vector<number>& times_;
    std::vector<std::size_t> order_;
    long digits_;
    const march_watch& watch_;
    const proof_route& route_;
    partial_trajectory part_;
    std::vector<bool> done_;  // times at which a value jumps
    needed_bits bits_;
    long most_undecided_;
};

}  // namespace

partial_trajectory proved_part_of_hybrid(const hybrid_system& system, const std::vector<number>& times, long digits,
                                         const march_watch& watch, const proof_route& route) {
    return hybrid_runs(system, times, digits, watch, route).part();
}

hybrid_branches branches_at_times(const hybrid_system& system, const std::vector<number>& times, long digits) {
    const auto order = in_order(system, times);
    needed_bits bits(digits);
    const long most_undecided = most_bits_of_undecided(bits);
    for (;;) {
        hybrid_branches found;
        hybrid_path path(system, bits.now());
        long events = -1;
        std::optional<std::size_t> failed;
        for (const std::size_t index : order) {
            if (!path.at(times[index], times[order.back()])) {
                failed = index;
                break;
            }
            if (path.events() != events) {
                events = path.events();
                found.branches.push_back({path.piece().system, {}});
            }
            found.branches.back().times.push_back(index);
        }
        if (!failed) {
            return found;
        }
        try {
            raise_path_bits(bits, path, most_undecided, "time", text_of_time(times[*failed]));
        } catch (const error& problem) {
            found.missing = problem;
            return found;
        }
    }
}

}  // namespace libration::ode
