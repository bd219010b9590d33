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

#include "../expansion/set_values.hpp"
#include "../integration/closed_form/constant_solution.hpp"
#include "../integration/closed_form/linear_flow.hpp"
#include "exact_zeros.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/integration/step_limits.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/printed_number.hpp"
#include "small_divisor.hpp"
#include "time_order.hpp"

namespace libration::ode {

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
            throw error(error_kind::argument, error_subject::time, text_of_time(time),
                        "is before the initial point, where the equation is singular: choose times after it");
        }
    }
    return march.at(time);
}

/// Why an integration ended before a time, unless by too few bits.
inline std::optional<std::string> reason_of_end(proved_march& march, const explicit_system& system, bool forward) {
    if (march.end() == stop::precision) {
        return std::nullopt;
    }
    const ball reached = march.reached();
    const auto state = march.at_end();
    const std::string divisor = state ? small_divisor_text(system, reached, *state) : "";
    return "is not reached: the solution is proved to exist up to " + proved_reach_text(reached, forward) +
           ", where the step size falls below its minimum, 2^" + std::to_string(log2_of_least_step(march.bits())) +
           " of the time since the start (probably a singularity; more digits permit shorter steps" +
           (divisor.empty() ? "" : "; " + divisor) + ")";
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

/// From so many unknowns on, with their lower derivatives, a run that ended is followed by one with as many bits as its
/// loss justifies, instead of some more: runs take long.
inline constexpr std::size_t many_unknowns = 6;
/// Where a run by theorem G ends in a smaller part of the time, the next one of so many unknowns is by theorem V.
inline constexpr double least_part_by_comparison = 1. / 16;
inline constexpr std::size_t most_unknowns_instead_of_comparison = 40;
/// After so many runs with values that contain 0, none follows one of more steps times unknowns times squared bits;
/// some seconds.
inline constexpr int usual_runs_with_zeros = 3;
inline constexpr double most_work_of_run_with_zeros = 1L << 28;

/// Runs from the initial point through all times, each with more bits than the one before, until every digit is proved
/// or no run proves more.
class proving_runs {
public:
    proving_runs(const explicit_system& system, const std::vector<number>& times, long digits, const march_watch& watch,
                 further_question further = {}, const proof_route& route = {}, step_observer observer = {},
                 const kept_part& kept = {})
        : system_(system),
          times_(times),
          digits_(digits),
          watch_(watch),
          further_(std::move(further)),
          route_(route),
          observer_(std::move(observer)),
          kept_(kept),
          order_(in_order(system, times)),
          constancy_(further_.answered ? constancy::none : constancy_of(system)),
          linear_(!further_.answered && route.matrix_exponential && route.integrator == integrator_choice::automatic
                      ? linear_flow::of(system)
                      : std::nullopt),
          zeros_(system),
          names_(asked_of(names_of_state(system))),
          unknowns_(names_of_state(system).size()),
          done_(times.size()),
          ends_{times.size(), times.size()} {
        part_.states.resize(times.size());
    }

    /// Throws only errors of the kind argument.
    partial_trajectory part() {
        part_.missing =
            prove_digits(digits_, error_subject::time,
                         [this](const run_bits& run, run_demand& demand) { pass_through_times(run, demand); },
                         {.bits = bits_of_first_run(digits_), .error_bits = further_.error_bits});
        for (const collocation_use& each : collocation_) {
            if (each.steps > 0) {
                part_.collocation.push_back(each);
            }
        }
        return std::move(part_);
    }

private:
    // One run.
    void pass_through_times(const run_bits& run, run_demand& demand) {
        std::optional<proved_march> march;
        bool forward = true;
        for (std::size_t place = 0; place < order_.size() && !demand.repeats(); ++place) {
            const asked_time& each = order_[place];
            if (done_[each.index] || place >= ends_[each.forward ? 1 : 0]) {
                continue;
            }
            const std::string time = text_of_time(times_[each.index]);
            auto state = state_in_closed_form(each.index, run.bits);
            if (!state && (!march || each.forward != forward)) {
                demand.cost(march ? march->steps() : 0);
                forward = each.forward;
                begin(march, run, forward);
                march->aim(times_[farthest(forward)]);
                march->observe(observer_);
                if (further_.answered) {
                    march->keep_derivative();
                }
            }
            if (!state) {
                state = state_at(*march, system_, times_[each.index], run.bits);
                collocation_[forward ? 1 : 0] = march->collocation();
                if (state && constancy_ == constancy::as_defined) {  // it exists up to this time
                    state = enclosed_start(system_, run.bits);
                }
            }
            if (!state) {
                if (const auto reason = reason_of_end(*march, system_, forward)) {
                    demand.ended(time, *reason);
                    ends_[forward ? 1 : 0] = place;
                } else {
                    const auto part_up_to = [&](std::size_t index) {
                        return part_of_way(system_.point(), march->reached(), times_[index]);
                    };
                    const double part = std::min(part_up_to(order_.back().index), part_up_to(each.index));
                    if (march->ends_by_comparison() && part < least_part_by_comparison &&
                        unknowns_ <= most_unknowns_instead_of_comparison &&
                        route_.integrator == integrator_choice::automatic) {
                        // Theorem G does not resolve unknowns that grow from 0 one after the other.
                        route_.comparison = false;
                        demand.ended_part_way(1, time);
                    } else if (march->ends_by_comparison() || unknowns_ >= many_unknowns) {
                        demand.ended_by_steady_loss(part, time);
                    } else {
                        demand.ended_part_way(part, time);
                    }
                }
                continue;
            }
            if (!further_.answered) {
                zeros_.put(*state, times_[each.index]);
            }
            demand.improve(part_.states[each.index], asked_of(*state), time, names_);
            if (place + 1 == order_.size()) {
                end_with_zeros(asked_of(*state), part_.states[each.index], time, march ? march->steps() : 0, run.bits);
            }
            if (demand.repeats()) {
                break;
            }
            const bool answered = !further_.answered || further_.answered(*march, each.index, *state);
            if (!all_have_digits(part_.states[each.index])) {
                continue;
            }
            done_[each.index] = answered;
            if (!answered) {
                demand.more_error_bits(time);
            }
        }
        demand.cost(march ? march->steps() : 0);
    }

    // Of many unknowns, some of which are so much smaller than others that each run only shows a few more of them.
    void end_with_zeros(const std::vector<ball>& state, const std::vector<known_value>& known, const std::string& time,
                        long steps, long bits) {
        std::size_t count = 0, first = 0;
        for (std::size_t k = state.size(); k-- > 0;) {
            if (!known[k].decimal && is_finite(state[k]) && contains_zero(state[k])) {
                first = k;
                ++count;
            }
        }
        const double work = static_cast<double>(steps) * static_cast<double>(unknowns_) * static_cast<double>(bits) *
                            static_cast<double>(bits);
        if (count > 0 && ++runs_with_zeros_ > usual_runs_with_zeros && work > most_work_of_run_with_zeros) {
            throw error(error_kind::undecided, error_subject::time, time,
                        "has a value of " + names_[first] + " that " + std::to_string(bits) +
                            " bits do not distinguish from 0: |" + names_[first] + "| < " + known[first].bound +
                            (count > 1 ? ", and " + std::to_string(count - 1) + " more such values" : "") +
                            " (more --digits begin with more bits)");
        }
    }

    // Kept steps have no derivative of the flow.
    void begin(std::optional<proved_march>& march, const run_bits& run, bool forward) const {
        if (kept_.steps != nullptr && !further_.answered) {
            march.emplace(kept_, system_, run.bits, forward ? 1 : -1, watch_, route_);
        } else {
            march.emplace(system_, run.bits, watch_, run.error_bits, route_);
        }
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

    // Without steps: the initial values of a constant solution, and the exponential of the matrix of a linear system;
    // no longer if that lacks digits.
    std::optional<std::vector<ball>> state_in_closed_form(std::size_t index, long bits) {
        if (constancy_ == constancy::everywhere) {
            return enclosed_start(system_, bits);
        }
        if (!linear_) {
            return std::nullopt;
        }
        auto state =
            linear_->at(times_[index], bits, [&](std::vector<ball>& values) { zeros_.put(values, times_[index]); });
        if (!state) {
            linear_.reset();
        } else if (observer_) {
            const precision_scope scope(20);
            const ball start = constant_value<ball>::of(system_.point());
            observer_({midpoint_of(start).convert_to<double>(),
                       midpoint_of(constant_value<ball>::of(times_[index]) - start).convert_to<double>(), bits, 0,
                       step_method::exponential, -std::numeric_limits<double>::infinity()});
        }
        return state;
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

    const explicit_system& system_;
    const std::vector<number>& times_;
    long digits_;
    const march_watch& watch_;
    further_question further_;
    proof_route route_;
    step_observer observer_;
    kept_part kept_;
    std::vector<asked_time> order_;
    constancy constancy_;  ///< `none` also if anything besides the values is requested
    std::optional<linear_flow> linear_;
    exact_zeros zeros_;
    std::vector<std::string> names_;  ///< of the requested values
    std::size_t unknowns_;
    int runs_with_zeros_ = 0;
    std::vector<bool> done_;
    std::array<std::size_t, 2> ends_;  ///< the places of the first times not reached, backwards and forwards
    std::array<collocation_use, 2> collocation_{};  ///< of the last runs
    partial_trajectory part_;
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
