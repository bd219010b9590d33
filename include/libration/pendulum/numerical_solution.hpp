// The numerical solution at a list of times: the Runge-Kutta method, each step computed once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

#include "libration/pendulum/runge_kutta.hpp"

namespace libration {

/// (theta, omega) at dimensionless times, in their order, from the state at time 0 in steps of h > 0: one integration
/// forwards through the times from 0 on and one backwards through those before. advance(way, i) advances the
/// runge_kutta_march `way` to the time of index i and returns the state there. O((longest + earliest time)/h).
template <scalar T, class Advance>
std::vector<series::jet<T>> numerical_solution(const series::jet<T>& start, const std::vector<T>& times, const T& step,
                                               const Advance& advance) {
    std::vector<std::size_t> by_time(times.size());
    std::iota(by_time.begin(), by_time.end(), std::size_t{0});
    std::sort(by_time.begin(), by_time.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    const auto first_after = std::find_if(by_time.begin(), by_time.end(), [&](std::size_t i) { return times[i] >= 0; });
    std::vector<series::jet<T>> states(times.size(), start);
    runge_kutta_march<T> forwards(start, step);
    std::for_each(first_after, by_time.end(), [&](std::size_t i) { states[i] = advance(forwards, i); });
    runge_kutta_march<T> backwards(start, step);
    std::for_each(std::make_reverse_iterator(first_after), by_time.rend(),
                  [&](std::size_t i) { states[i] = advance(backwards, i); });
    return states;
}

/// By runge_kutta_march::advance_to(), without a progress callback.
/// Throws error when an integration needs more than runge_kutta_march::most_steps.
template <scalar T>
std::vector<series::jet<T>> numerical_solution(const series::jet<T>& start, const std::vector<T>& times,
                                               const T& step) {
    return numerical_solution(start, times, step,
                              [&](runge_kutta_march<T>& march, std::size_t i) { return march.advance_to(times[i]); });
}

}  // namespace libration
