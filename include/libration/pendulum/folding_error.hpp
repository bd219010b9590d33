// The effect of the accuracy of T* at late times: the exact solution on [0, T*], folded by an inexact T*.
#pragma once

#include <utility>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/periodic_extension.hpp"

namespace libration::pendulum {

/// The exact canonical motion from the top, as a function of x = t/T* with the T* of a rule. Between the bottom and
/// that T* it continues as the motion does.
template <scalar T>
class exact_arc {
public:
    /// Throws error at E = 2.
    exact_arc(const motion& canonical, const period_rule& by)
        : solution_(canonical),
          effective_period_(effective_period_by(by, energy_level_of<T>(canonical))),
          stretch_(effective_period_ / effective_period(energy_level_of<T>(canonical))) {}

    series::jet<T> operator()(const T& x) const {
        const pendulum_state<T> at = solution_.from_top(T(x * stretch_));
        return {at.theta, at.omega * effective_period_};
    }

private:
    exact_solution<T> solution_;
    T effective_period_;
    T stretch_;
};

/// An angle with a large error, and the exact one.
template <scalar T>
struct angle_pair {
    T found;
    T expected;
    T error;  ///< |found - expected|
};

/// The largest error of theta at the times (p + i/points) T, i = 0 .. points, of the canonical motion of an energy,
/// counterclockwise, whose fundamental arc is exact and whose folding has the T* of a rule [paper (newseries)]: T* is
/// the only source of error. All bottoms are among the times if 4 (rotation 2) divides points. points + 1 evaluations.
/// Throws error at E = 2.
template <rounding_scalar T>
angle_pair<T> folding_error(const exact& energy, const period_rule& by, const integer& periods, int points) {
    using std::abs;
    const motion m = motion::of_energy(energy);
    const exact_solution<T> truth(m);
    const periodic_extension<T, exact_arc<T>> folded(m, exact_arc<T>(m, by), by);
    angle_pair<T> worst{T(0), T(0), T(-1)};
    for (int i = 0; i <= points; ++i) {
        const exact time{rational(periods) + rational(i, points), unit::period, ""};
        const T expected = truth(time).theta;
        const T found = folded(time).value;
        const T error = abs(T(found - expected));
        if (error > worst.error) {
            worst = {found, expected, error};
        }
    }
    return worst;
}

/// sqrt(2E) |dT| (p + 1) for an error dT of T: folding_error to first order in dT, if that T is too short. The motion
/// is out of step by p + 1 times dT when it passes the last bottom of the period, with the speed sqrt(2E).
template <scalar T>
T folding_error_estimate(const exact& energy, const T& period_error, const integer& periods) {
    using std::sqrt;
    return sqrt(from_exact<T>(energy * exactly(2))) * period_error * from_rational<T>(rational(periods + 1));
}

}  // namespace libration::pendulum
