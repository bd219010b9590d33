// The paper's numerical solution, at as many times as a figure can show as separate points.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/numerical_solution.hpp"
#include "text/input_error.hpp"
#include "value_with_error.hpp"

namespace libration::studies {

/// The paper's numerical solution: Runge-Kutta in double from the same initial state, against the exact solution.
inline std::vector<value_with_error> marched(const pendulum::motion& m, const std::vector<exact>& times,
                                             const exact& step) {
    series::jet<double> start{};
    std::vector<double> rounded;
    rounded.reserve(times.size());
    {
        const precision_scope scope(40);
        const pendulum::pendulum_state<mpfr> at = pendulum::exact_solution<mpfr>(m)(exact{});
        start = {narrow<double>(at.theta), narrow<double>(at.omega)};
        for (const exact& time : times) {
            rounded.push_back(narrow<double>(dimensionless_time<mpfr>(m, time)));
        }
    }
    const auto states = reading("--step", step.text, "write a larger step, or --times that end earlier",
                                [&] { return numerical_solution<double>(start, rounded, from_exact<double>(step)); });
    constexpr long digits_of_double = 17;
    return resolved(digits_of_double, 20, [&] {
        const pendulum::exact_solution<mpfr> truth(m);
        std::vector<value_with_error> values;
        values.reserve(times.size());
        for (std::size_t i = 0; i < times.size(); ++i) {
            const pendulum::phase<mpfr> at = truth.phases().at(times[i]);
            const mpfr theta = widen(states[i].value);
            values.push_back({theta, widen(states[i].slope), abs(theta - truth.at(at).theta), at.side == 0});
        }
        return values;
    });
}

/// About 41 of the times, evenly spaced, including the first and the last: as many points as a figure can show.
inline std::vector<exact> some_of(const std::vector<exact>& times) {
    constexpr std::size_t most = 41;
    if (times.size() <= most) {
        return times;
    }
    std::vector<exact> some;
    some.reserve(most);
    for (std::size_t i = 0; i < most; ++i) {
        some.push_back(times[i * (times.size() - 1) / (most - 1)]);
    }
    return some;
}

}  // namespace libration::studies
