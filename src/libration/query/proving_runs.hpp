// Repeated runs for the solution at a list of times, with more bits if digits are missing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../equation/needed_bits.hpp"
#include "../expansion/set_values.hpp"
#include "libration/integration/closed_form/constant_solution.hpp"
#include "libration/integration/closed_form/linear_flow.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

inline constexpr long largest_growth_of_bits = 6;

// A time in the order in which an integration reaches it.
struct asked_time {
    std::size_t index;
    bool forward;
};

inline std::vector<asked_time> in_order(const explicit_system& system, const std::vector<number>& times) {
    const precision_scope scope(40);
    std::vector<mpfr> gone;
    gone.reserve(times.size());
    for (const number& each : times) {
        gone.push_back(constant_value<mpfr>::of(each - system.point()));
    }
    std::vector<asked_time> order;
    for (std::size_t i = 0; i < times.size(); ++i) {
        order.push_back({i, !(gone[i] < 0)});
    }
    std::ranges::stable_sort(order, [&](const asked_time& a, const asked_time& b) {
        return a.forward != b.forward ? a.forward : abs(gone[a.index]) < abs(gone[b.index]);
    });
    return order;
}

/// The state at a time, of an integration from the initial point: at a singular initial point its values themselves;
/// throws for times before it.
inline std::optional<std::vector<ball>> state_at(proved_march& march, const explicit_system& system, const number& time,
                                                 long bits) {
    if (system.singular()) {
        const number gone = time - system.point();
        if (const auto exactly = gone.fraction(); exactly && *exactly == 0) {
            return enclosed_start(system, bits);
        }
        if (arb_is_negative(constant_value<ball>::of(gone).handle()) != 0) {
            throw error(error_kind::argument, "time", text_of_time(time),
                        "is before the initial point, where the equation is singular: choose times after it");
        }
    }
    return march.at(time);
}

/// Throws error of the kind undecided if an integration ended before this time for another reason than too few bits.
inline void require_more_bits(const proved_march& march, const number& time, bool forward) {
    if (march.end() == stop::precision) {
        return;
    }
    throw error(error_kind::undecided, "time", text_of_time(time),
                "is not reached: the solution is proved to exist up to " + proved_reach_text(march.reached(), forward) +
                    ", where the steps become too small, as they do near a singularity");
}

/// An additional request to a run besides the values.
struct further_question {
    /// Called with the state at time number `index`, whose digits are proved or which is not distinguished from 0,
    /// when the integration has reached it. False if it needs a run with more bits, also of the error maps.
    std::function<bool(proved_march& march, std::size_t index, const std::vector<ball>& state)> answered = {};
    /// The indices in the state of the requested values; empty for all of them.
    std::vector<std::size_t> places = {};
    /// The bits of the error maps of the first run.
    long error_bits = proved_march::usual_error_bits;
};

/// Runs from the initial point through all times, each with more bits than the one before, until every digit is proved
/// or no run proves more.
class proving_runs {
public:
    proving_runs(const explicit_system& system, const std::vector<number>& times, long digits, const march_watch& watch,
                 further_question further = {}, const proof_route& route = {}, step_observer observer = {})
        : system_(system),
          times_(times),
          digits_(digits),
          watch_(watch),
          further_(std::move(further)),
          route_(route),
          observer_(std::move(observer)),
          error_bits_(further_.error_bits),
          order_(in_order(system, times)),
          constancy_(further_.answered ? constancy::none : constancy_of(system)),
          linear_(!further_.answered && route.matrix_exponential && route.integrator == integrator_choice::automatic
                      ? linear_flow::of(system)
                      : std::nullopt),
          done_(times.size()),
          ends_{times.size(), times.size()},
          bits_(digits) {
        part_.states.resize(times.size());
    }

    /// Throws only errors of the kind argument.
    partial_trajectory part() {
        try {
            while (!complete()) {
            }
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            miss(problem);
        }
        for (const collocation_use& each : collocation_) {
            if (each.steps > 0) {
                part_.collocation.push_back(each);
            }
        }
        return std::move(part_);
    }

private:
    // One run; if it does not prove every digit, the next one has more bits.
    bool complete() {
        std::optional<proved_march> march;
        bool forward = true;
        long steps = 0;  // before those of `march`
        std::optional<std::size_t> at_zero;
        for (std::size_t place = 0; place < order_.size(); ++place) {
            const asked_time& each = order_[place];
            if (done_[each.index] || place >= ends_[each.forward ? 1 : 0]) {
                continue;
            }
            auto state = state_in_closed_form(each.index);
            if (!state && (!march || each.forward != forward)) {
                steps += march ? march->steps() : 0;
                forward = each.forward;
                march.emplace(system_, bits_.now(), watch_, error_bits_, route_);
                march->aim(times_[farthest(forward)]);
                march->observe(observer_);
                if (further_.answered) {
                    march->keep_derivative();
                }
            }
            if (!state) {
                state = state_at(*march, system_, times_[each.index], bits_.now());
                collocation_[forward ? 1 : 0] = march->collocation();
                if (state && constancy_ == constancy::as_defined) {  // it exists up to this time
                    state = enclosed_start(system_, bits_.now());
                }
            }
            if (!state) {
                if (ends(*march, each)) {
                    ends_[forward ? 1 : 0] = place;
                    continue;
                }
                bits_.raise_to(bits_to_go_on(*march, each.index), "time", text_of(each.index));
                return false;
            }
            if (!proved(each.index, asked_of(*state))) {
                return false;
            }
            const bool answered = !further_.answered || further_.answered(*march, each.index, *state);
            if (!all_have_digits(part_.states[each.index])) {
                at_zero = at_zero.value_or(each.index);
                continue;
            }
            if (!answered) {
                error_bits_ *= 2;
                bits_.raise_to(bits_.now() + error_bits_ / 4, "time", text_of(each.index));
                return false;
            }
            done_[each.index] = true;
        }
        return !at_zero || given_up(*at_zero, steps + (march ? march->steps() : 0));
    }

    // The last time in a direction that is still to be reached.
    std::size_t farthest(bool forward) const {
        std::size_t index = 0;
        for (std::size_t place = 0; place < ends_[forward ? 1 : 0]; ++place) {
            if (order_[place].forward == forward && !done_[order_[place].index]) {
                index = order_[place].index;
            }
        }
        return index;
    }

    // Without steps: the initial values of a constant solution, and the exponential of the matrix of a linear system; no
    // longer if that lacks digits.
    std::optional<std::vector<ball>> state_in_closed_form(std::size_t index) {
        if (constancy_ == constancy::everywhere) {
            return enclosed_start(system_, bits_.now());
        }
        if (!linear_) {
            return std::nullopt;
        }
        auto state = linear_->at(times_[index], bits_.now());
        if (!state) {
            linear_.reset();
        } else if (observer_) {
            const precision_scope scope(20);
            const ball start = constant_value<ball>::of(system_.point());
            observer_({midpoint_of(start).convert_to<double>(),
                       midpoint_of(constant_value<ball>::of(times_[index]) - start).convert_to<double>(), bits_.now(),
                       0, step_method::exponential, -std::numeric_limits<double>::infinity()});
        }
        return state;
    }

    // Whether an integration without a state ended for another reason than too few bits: then no run gets further.
    bool ends(const proved_march& march, const asked_time& at) {
        try {
            require_more_bits(march, times_[at.index], at.forward);
            return false;
        } catch (const error& problem) {
            miss(problem);
            return true;
        }
    }

    // The digits of the values, or bounds; false if one that excludes 0 needs more bits.
    bool proved(std::size_t index, const std::vector<ball>& values) {
        auto& state = part_.states[index];
        state.resize(values.size());
        const ball* too_wide = nullptr;
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (state[k].decimal) {
                continue;
            }
            improve(state[k], values[k], digits_);
            if (!state[k].decimal && !contains_zero(values[k])) {
                too_wide = &values[k];
            }
        }
        if (too_wide != nullptr) {
            bits_.raise_for(*too_wide, "time", text_of(index));
        }
        return too_wide == nullptr;
    }

    // Whether no more runs are tried for values that contain 0, after one of so many steps.
    bool given_up(std::size_t index, long steps) {
        if (bits_.raised_at_zero(steps, "time", text_of(index))) {
            return false;
        }
        miss(error(error_kind::undecided, "time", text_of(index),
                   text_of_undecided(asked_of(names_of_state(system_)), part_.states[index], bits_.now())));
        return true;
    }

    void miss(const error& problem) {
        if (!part_.missing) {
            part_.missing = problem;
        }
    }

    // Of all values of a state, or all their names.
    template <class Value>
    std::vector<Value> asked_of(const std::vector<Value>& state) const {
        if (further_.places.empty()) {
            return state;
        }
        std::vector<Value> asked;
        for (const std::size_t place : further_.places) {
            asked.push_back(state[place]);
        }
        return asked;
    }

    // The bits lost up to here, extrapolated to the longest time, plus a margin.
    long bits_to_go_on(const proved_march& march, std::size_t index) const {
        const long bits = bits_.now();
        const precision_scope scope(20);
        const mpfr gone = abs(midpoint_of(march.reached() - constant_value<ball>::of(system_.point())));
        const mpfr asked = abs(constant_value<mpfr>::of(times_[order_.back().index] - system_.point()));
        const mpfr here = abs(constant_value<mpfr>::of(times_[index] - system_.point()));
        const mpfr far = std::max(asked, here);
        const mpfr times = gone == 0 ? mpfr(largest_growth_of_bits) : mpfr(far / gone * 21 / 20);
        const long wanted =
            times > largest_growth_of_bits ? largest_growth_of_bits * bits : mpfr(times * bits).convert_to<long>();
        return std::max(bits + bits / 4, wanted + bits_of_digits(digits_) + first_guard_bits);
    }

    std::string text_of(std::size_t time) const { return text_of_time(times_[time]); }

    const explicit_system& system_;
    const std::vector<number>& times_;
    long digits_;
    const march_watch& watch_;
    further_question further_;
    proof_route route_;
    step_observer observer_;
    long error_bits_;
    std::vector<asked_time> order_;
    constancy constancy_;  ///< `none` also if anything besides the values is requested
    std::optional<linear_flow> linear_;
    std::vector<bool> done_;
    std::array<std::size_t, 2> ends_;  ///< the places of the first times not reached, backwards and forwards
    std::array<collocation_use, 2> collocation_{};  ///< of the last runs
    partial_trajectory part_;
    needed_bits bits_;
};

/// The digits of a trajectory if nothing is missing; otherwise throws the reason.
inline std::vector<std::vector<proved_decimal>> all_digits(const partial_trajectory& of) {
    if (of.missing) {
        throw error(*of.missing);
    }
    std::vector<std::vector<proved_decimal>> result;
    for (const auto& state : of.states) {
        auto& row = result.emplace_back();
        for (const known_value& each : state) {
            row.push_back(each.decimal.value());
        }
    }
    return result;
}

}  // namespace libration::ode
