// The solution of an equation at times of an interval, and its series about the initial point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "libration/integration/taylor/taylor_march.hpp"

namespace libration {

/// The solution at times by one integration in the current precision, and the slopes at the far end, the time farthest
/// from the initial point. A second integration in another precision has to agree (agreed_numbers).
struct solution_on_interval {
    mpfr start;
    std::vector<mpfr> times;
    std::vector<std::vector<mpfr>> values;  ///< [unknown][time]
    std::size_t far = 0;                    ///< the index of the far end among the times
    std::vector<mpfr> slopes;               ///< of the unknowns there
    bool one_sided = true;                  ///< whether no two times have the initial point between them

    mpfr reach() const { return times[far] - start; }
};

inline solution_on_interval solve_on(const ode::explicit_system& system, const std::vector<ode::number>& times) {
    solution_on_interval found{ode::constant_value<mpfr>::of(system.point()), {}, {}, 0, {}, true};
    for (const ode::number& each : times) {
        found.times.push_back(ode::constant_value<mpfr>::of(each));
    }
    const auto states = ode::march_through<mpfr>(system, times);
    found.values.resize(system.unknowns().size());
    for (const auto& state : states) {
        for (std::size_t i = 0; i < state.size(); ++i) {
            found.values[i].push_back(state[i][0]);
        }
    }
    const auto distance = [&](std::size_t i) { return mpfr(abs(mpfr(found.times[i] - found.start))); };
    for (std::size_t i = 1; i < times.size(); ++i) {
        found.far = distance(i) > distance(found.far) ? i : found.far;
    }
    found.one_sided = found.reach() != 0 && std::ranges::all_of(found.times, [&](const mpfr& t) {
                          return mpfr((t - found.start) * found.reach()) >= 0;
                      });
    if (found.one_sided) {
        const ode::tape tape = ode::tape::about_points(system);
        ode::taylor_expansion<mpfr> there(tape, 1);
        there.about(found.times[found.far], states[found.far]);
        for (std::size_t i = 0; i < states.front().size(); ++i) {
            found.slopes.push_back(there.coefficients(static_cast<int>(i))[1]);
        }
    }
    return found;
}

/// The series of the unknowns about the initial point in powers of s, s^root = t - t0, in the arithmetic of T.
template <rounding_scalar T>
struct series_about_start {
    series_about_start(const ode::explicit_system& system, int order)
        : tape(ode::tape::about_start(system)), expansion(tape, order) {
        expansion.about_start();
    }

    ode::tape tape;
    ode::taylor_expansion<T> expansion;
};

}  // namespace libration
