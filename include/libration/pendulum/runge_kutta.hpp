// The classical fourth-order Runge-Kutta method with a fixed step: the numerical solution used in the paper.
#pragma once

#include <cstdlib>
#include <string>
#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"
#include "libration/series/jet.hpp"

namespace libration {

/// One step h of theta' = omega, omega' = -sin theta; jets carry (theta, omega). Local error O(h^5).
template <scalar T>
series::jet<T> runge_kutta_step(const series::jet<T>& y, const T& h) {
    using std::sin;
    const T k1 = y.slope;
    const T l1 = -sin(y.value);
    const T k2 = y.slope + h * l1 / 2;
    const T l2 = -sin(T(y.value + h * k1 / 2));
    const T k3 = y.slope + h * l2 / 2;
    const T l3 = -sin(T(y.value + h * k2 / 2));
    const T k4 = y.slope + h * l3;
    const T l4 = -sin(T(y.value + h * k3));
    return {y.value + h * (k1 + (k2 + k3) * 2 + k4) / 6, y.slope + h * (l1 + (l2 + l3) * 2 + l4) / 6};
}

/// Integrates from one time to another in steps of h, the last one shortened or lengthened to arrive. The paper's step
/// is 1e-5.
template <scalar T>
class runge_kutta_march {
public:
    static constexpr long most_steps = 2'000'000'000;

    runge_kutta_march(series::jet<T> start, T step) : y_(std::move(start)), step_(std::move(step)) {}

    /// The state at dimensionless time t, from the state at the time of the last call (0 at first).
    /// Throws error when that needs more than most_steps steps.
    const series::jet<T>& advance_to(const T& t) {
        const integer steps = nearest_integer(widen(T((t - now_) / step_)));
        if (abs(steps) > most_steps) {
            throw error(
                error_kind::argument, error_subject::time, "",
                "needs " + integer(abs(steps)).str() + " Runge-Kutta steps, more than " + std::to_string(most_steps));
        }
        const long count = steps.convert_to<long>();
        const T h = count < 0 ? T(-step_) : step_;
        for (long i = 0; i < std::labs(count); ++i) {
            y_ = runge_kutta_step(y_, h);
        }
        const T rest = t - now_ - from_rational<T>(rational(steps)) * step_;
        y_ = runge_kutta_step(y_, rest);
        now_ = t;
        return y_;
    }

private:
    series::jet<T> y_;
    T step_;
    T now_ = T(0);
};

}  // namespace libration
