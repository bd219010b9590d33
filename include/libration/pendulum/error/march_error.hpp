// The error of the Runge-Kutta march on the separatrix, where the closed solution (critical) judges it: the horizontal
// line of the paper's figure "error".
#pragma once

#include <cstdint>
#include <string>

#include "libration/pendulum/numerical/runge_kutta.hpp"
#include "libration/pendulum/solution/critical_formula.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// What the march from (0, 2) misses. The solution departs from its neighbours like e^t on its way to the
/// top, so a step's own error arrives at time t multiplied by about e^(t-s): `undone` is the largest
/// |error| e^-t, without that growth.
struct march_error {
    mpfr norm;    ///< largest |theta - (critical)|, radians
    mpfr time;    ///< where it is
    mpfr undone;  ///< largest |theta - (critical)| e^-t, radians
};

/// Steps of h, rounded to the nearest whole number, from 0 to the end. Throws error for less than one step
/// and for more than runge_kutta_march allows.
inline long march_steps(const rational& step, const rational& end) {
    const precision_scope scope(60);
    const integer steps = nearest_integer(from_rational<mpfr>(rational(end / step)));
    if (steps < 1 || steps > runge_kutta_march<double>::most_steps) {
        throw error(error_kind::argument, "step", "",
                    "takes " + steps.str() + " Runge-Kutta steps to time " + end.str() + ", not 1 to " +
                        std::to_string(runge_kutta_march<double>::most_steps));
    }
    return steps.convert_to<long>();
}

/// The march of `steps` steps of h in T, compared after each of `samples` even parts of them, the last one included.
/// The times are whole multiples of h as T holds it, so no rounding of the clock is in the error. Compared at the
/// working precision in force, which has to be above that of T.
template <fixed_scalar T>
march_error separatrix_march_error(const rational& step, long steps, int samples) {
    const motion on_separatrix = motion::of_energy(2);
    const T h = from_rational<T>(step);
    const mpfr exact_h = widen(h);
    series::jet<T> state{T(0), T(2)};
    march_error result{mpfr(0), mpfr(0), mpfr(0)};
    long done = 0;
    for (int i = 1; i <= samples; ++i) {
        const auto goal = static_cast<long>(static_cast<std::int64_t>(steps) * i / samples);
        for (; done < goal; ++done) {
            state = runge_kutta_step(state, h);
        }
        const mpfr time = exact_h * done;
        const mpfr error = abs(widen(state.value) - critical_formula<mpfr>(on_separatrix, time));
        if (error > result.norm) {
            result.norm = error;
            result.time = time;
        }
        const mpfr undone = error * exp(-time);
        result.undone = undone > result.undone ? undone : result.undone;
    }
    return result;
}

}  // namespace libration::pendulum
