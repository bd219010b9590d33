// From run to run: the solution at a list of times, with more bits where digits are missing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/printed_number.hpp"
#include "needed_bits.hpp"
#include "set_values.hpp"

namespace libration::ode {

inline constexpr long largest_growth_of_bits = 6;

// A time in the order in which a march comes to it.
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

inline std::string text_of_time(const number& time) {
    const precision_scope scope(20);
    return to_decimal(constant_value<mpfr>::of(time), 12);
}

/// The state at a time, of a march from the start: at a singular start that itself, and nothing before it.
inline std::optional<std::vector<ball>> state_at(proved_march& march, const explicit_system& system, const number& time,
                                                 long bits) {
    if (system.singular()) {
        const number gone = time - system.point();
        if (const auto exactly = gone.fraction(); exactly && *exactly == 0) {
            return enclosed_start(system, bits);
        }
        if (arb_is_negative(constant_value<ball>::of(gone).handle()) != 0) {
            throw error(error_kind::argument, "time", text_of_time(time),
                        "is before the start, where the equation is singular: choose times behind it");
        }
    }
    return march.at(time);
}

/// Throws error of the kind undecided where a march ended before this time for another reason than too few bits.
inline void require_more_bits(const proved_march& march, const number& time, bool forward) {
    if (march.end() == march_end::precision) {
        return;
    }
    throw error(error_kind::undecided, "time", text_of_time(time),
                "is not reached: the solution is proved to exist up to " + proved_reach_text(march.reached(), forward) +
                    ", where the steps become too small, as they do near a singularity");
}

/// What a run is asked besides the values.
struct further_question {
    /// With the state at time number `index`, whose digits are proved, where the march is. False where it needs a run
    /// with more bits, of the maps of errors too.
    std::function<bool(proved_march& march, std::size_t index, const std::vector<ball>& state)> answered = {};
    /// The places in the state whose values are asked; empty: all of them.
    std::vector<std::size_t> places = {};
};

/// Runs from the start through all times, each with more bits than the one before, until every digit is proved.
class proving_runs {
public:
    proving_runs(const explicit_system& system, const std::vector<number>& times, long digits, const march_watch& watch,
                 further_question further = {}, const proof_route& route = {})
        : system_(system),
          times_(times),
          digits_(digits),
          watch_(watch),
          further_(std::move(further)),
          route_(route),
          order_(in_order(system, times)),
          bits_(digits) {}

    std::vector<std::vector<proved_decimal>> result() {
        while (!complete()) {
        }
        return std::move(values_);
    }

private:
    // One run; where it does not prove every digit, the next one has more bits.
    bool complete() {
        values_.assign(times_.size(), {});
        std::optional<proved_march> march;
        bool forward = true;
        for (const asked_time& each : order_) {
            if (!march || each.forward != forward) {
                forward = each.forward;
                march.emplace(system_, bits_.now(), watch_, error_bits_, route_);
                if (further_.answered) {
                    march->keep_derivative();
                }
            }
            unproved_ = each.index;
            const auto state = state_at(*march, system_, times_[each.index], bits_.now());
            if (!state) {
                require_more_bits(*march, times_[each.index], forward);
                bits_.raise_to(bits_to_go_on(*march), "time", text_of(unproved_));
                return false;
            }
            for (const ball& value : asked_of(*state)) {
                const auto decimal = bits_.printed(value, "time", text_of(unproved_));
                if (!decimal) {
                    return false;
                }
                values_[each.index].push_back(*decimal);
            }
            if (further_.answered && !further_.answered(*march, each.index, *state)) {
                error_bits_ *= 2;
                bits_.raise_to(bits_.now() + error_bits_ / 4, "time", text_of(each.index));
                return false;
            }
        }
        return true;
    }

    std::vector<ball> asked_of(const std::vector<ball>& state) const {
        if (further_.places.empty()) {
            return state;
        }
        std::vector<ball> asked;
        for (const std::size_t place : further_.places) {
            asked.push_back(state[place]);
        }
        return asked;
    }

    // As many bits as were lost until here, for every further stretch of time, and some more.
    long bits_to_go_on(const proved_march& march) const {
        const long bits = bits_.now();
        const precision_scope scope(20);
        const mpfr gone = abs(midpoint_of(march.reached() - constant_value<ball>::of(system_.point())));
        const mpfr asked = abs(constant_value<mpfr>::of(times_[order_.back().index] - system_.point()));
        const mpfr here = abs(constant_value<mpfr>::of(times_[unproved_] - system_.point()));
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
    long error_bits_ = proved_march::usual_error_bits;
    std::vector<asked_time> order_;
    std::vector<std::vector<proved_decimal>> values_;
    std::size_t unproved_ = 0;
    needed_bits bits_;
};

}  // namespace libration::ode
