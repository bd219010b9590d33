#include "libration/ode/trajectory.hpp"

#include <cstddef>

#include "libration/digits/agreed_values.hpp"
#include "libration/ode/step.hpp"

namespace libration::ode {

namespace {

// All values in the order of the times.
std::vector<mpfr> marched_values(const explicit_system& system, const std::vector<number>& times,
                                 const series::block_product<mpfr>* fast) {
    std::vector<mpfr> all;
    for (const auto& state : march_through<mpfr>(system, times, fast)) {
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

// At the start itself zeros are exact.
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

}  // namespace

std::vector<solution_state<mpfr>> trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const series::block_product<mpfr>* fast) {
    const auto values = agreed_values(
        digits,
        [&](long guard) {
            const precision_scope scope(digits + guard);
            return marched_values(system, times, fast);
        },
        [&] { return zeros_of(system, times); });
    std::vector<solution_state<mpfr>> result;
    auto next = values.begin();
    for (std::size_t i = 0; i < times.size(); ++i) {
        auto& state = result.emplace_back();
        for (const unknown_function& each : system.unknowns()) {
            state.emplace_back(next, next + each.order);
            next += each.order;
        }
    }
    return result;
}

}  // namespace libration::ode
