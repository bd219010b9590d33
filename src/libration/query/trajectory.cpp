#include "libration/query/trajectory.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "libration/digits/agreed_values.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/plane/path.hpp"

namespace libration::ode {

namespace {

// All values in the order of the times.
template <class R>
std::vector<R> in_order(const std::vector<solution_state<R>>& states) {
    std::vector<R> all;
    for (const auto& state : states) {
        for (const auto& of_unknown : state) {
            all.insert(all.end(), of_unknown.begin(), of_unknown.end());
        }
    }
    return all;
}

bool is_exactly_zero(const number& x) {
    const auto plain = x.plain();
    return plain && plain->coefficient == 0;
}

// The states that have these values.
template <class R>
std::vector<solution_state<R>> states_of(const explicit_system& system, const std::vector<R>& values) {
    std::vector<solution_state<R>> result;
    for (auto next = values.begin(); next != values.end();) {
        auto& state = result.emplace_back();
        for (const unknown_function& each : system.unknowns()) {
            state.emplace_back(next, next + each.order);
            next += each.order;
        }
    }
    return result;
}

// At the initial point itself zeros are exact.
std::vector<bool> zeros_of(const explicit_system& system, const std::vector<number>& times) {
    std::vector<bool> zeros;
    for (const number& time : times) {
        const bool at_start = is_exactly_zero(time - system.point());
        for (const auto& of_unknown : system.starts()) {
            for (const number& value : of_unknown) {
                zeros.push_back(at_start && is_exactly_zero(value));
            }
        }
    }
    return zeros;
}

// The indices of the times with complete states.
std::vector<std::size_t> places_reached(const partial_states<mpfr>& of) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < of.states.size(); ++i) {
        if (of.complete_at(i)) {
            places.push_back(i);
        }
    }
    return places;
}

template <class Item>
std::vector<Item> items_at(const std::vector<std::size_t>& places, const std::vector<Item>& of) {
    std::vector<Item> items;
    items.reserve(places.size());
    for (const std::size_t place : places) {
        items.push_back(of[place]);
    }
    return items;
}

// By two runs of different precision and order; the times are those that the first run reaches.
partial_states<mpfr> agreed_part(const explicit_system& system, const std::vector<number>& times, long digits,
                                 const march_of_system& march) {
    partial_states<mpfr> result;
    result.states.assign(times.size(), solution_state<mpfr>(system.unknowns().size()));
    std::vector<number> reached = times;
    std::optional<std::vector<std::size_t>> places;
    const auto values = agreed_values(
        digits,
        [&](long guard) {
            const precision_scope scope(digits + guard);
            auto now = march(system, reached);
            result.collocation = std::move(now.collocation);
            if (!places) {
                places = places_reached(now);
                reached = items_at(*places, times);
                result.missing = std::move(now.missing);
                return in_order(items_at(*places, now.states));
            }
            if (now.missing) {
                throw error(*now.missing);
            }
            return in_order(now.states);
        },
        [&] { return zeros_of(system, reached); });
    auto states = states_of(system, values);
    for (std::size_t i = 0; i < states.size(); ++i) {
        result.states[(*places)[i]] = std::move(states[i]);
    }
    return result;
}

}  // namespace

partial_states<mpfr> part_of_trajectory(const explicit_system& system, const std::vector<number>& times, long digits,
                                        const march_of_system& march) {
    return states_of_parts<mpfr>(system, times.size(),
                                 [&](const explicit_system& part) { return agreed_part(part, times, digits, march); });
}

partial_states<mpfr> part_of_trajectory(const explicit_system& system, const std::vector<number>& times, long digits,
                                        const series::block_product<mpfr>* fast) {
    return part_of_trajectory(system, times, digits, [&](const explicit_system& part, const std::vector<number>& at) {
        return march_as_far_as_possible<mpfr>(part, at, fast);
    });
}

std::vector<solution_state<mpfr>> trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const series::block_product<mpfr>* fast) {
    auto part = part_of_trajectory(system, times, digits, fast);
    if (part.missing) {
        throw error(*part.missing);
    }
    return std::move(part.states);
}

std::vector<solution_state<complex_number<mpfr>>> trajectory_along(const explicit_system& system,
                                                                   const std::vector<complex_constant>& corners,
                                                                   const std::vector<complex_constant>& times,
                                                                   long digits) {
    // Without corners, the initial point itself may be one of the points.
    const auto vanishing = [&] {
        std::vector<bool> zeros;
        for (const complex_constant& time : times) {
            const bool at_start = corners.empty() && is_exactly_zero(time.im);
            const auto own = zeros_of(system, {time.re});
            for (const bool zero : own) {
                zeros.push_back(at_start && zero);
            }
        }
        return zeros;
    };
    const auto values = agreed_complex_values(
        digits,
        [&](long guard) {
            const precision_scope scope(digits + guard);
            return in_order(states_along<mpfr>(system, corners, times));
        },
        vanishing);
    return states_of(system, values);
}

}  // namespace libration::ode
