// The error of the Runge-Kutta method on the separatrix, measured against the closed solution (critical): the
// horizontal line of the paper's figure "error".
#pragma once

#include <cstdint>
#include <string>

#include "libration/pendulum/critical_formula.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The error of the integration from (0, 2). The solution departs from its neighbours like e^t towards the top, so the
/// error of a single step is multiplied by about e^(t-s) at time t: `undone` is the largest |error| e^-t, without that
/// growth.
struct march_error {
    mpfr norm;    ///< largest |theta - (critical)|, radians
    mpfr time;    ///< where it is
    mpfr undone;  ///< largest |theta - (critical)| e^-t, radians
};

/// Steps of h, rounded to the nearest integer, from 0 to the end. Throws error for less than one step
/// and for more than runge_kutta_march allows.
inline long march_steps(const rational& step, const rational& end) {
    const precision_scope scope(60);
    const integer steps = nearest_integer(from_rational<mpfr>(rational(end / step)));
    if (steps < 1 || steps > runge_kutta_march<double>::most_steps) {
        throw error(error_kind::argument, "step", "",
                    "needs " + steps.str() + " Runge-Kutta steps to time " + end.str() + ", not 1 to " +
                        std::to_string(runge_kutta_march<double>::most_steps));
    }
    return steps.convert_to<long>();
}

/// The integration by `steps` steps of h in T, compared after each of `samples` equal parts of them, the last one
/// included. The times are integer multiples of h as represented in T, so the error contains no rounding of the times.
/// Compared at the current working precision, which must be above that of T.
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
