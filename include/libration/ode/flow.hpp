// The pendulum's equation integrated along straight lines in the complex time plane, by Taylor series of the equation
// alone: no elliptic function, no period, no place of a singularity. It judges what is said of those.
#pragma once

#include <algorithm>
#include <utility>

#include "libration/series/complex_series.hpp"

namespace libration {

/// theta, omega, sin theta and cos theta at one instant.
template <scalar T>
struct flow_state {
    complex_number<T> theta;
    complex_number<T> omega;
    complex_number<T> sine;
    complex_number<T> cosine;
};

/// A motion of theta'' + sin theta = 0 as the system of four equations [Fairen1988]
///     theta' = omega,  omega' = -s,  s' = c omega,  c' = -s omega,
/// whose right-hand sides are polynomials. A step takes 11/10 as many powers as the precision has digits, plus 10, and
/// is as long as the last of them allow. It never ends on a path through a singularity. Errors: some epsilon a step,
/// grown by the flow itself (like e^t next to the top).
template <rounding_scalar T>
class flow {
public:
    /// From theta and omega at time 0.
    flow(const T& theta, const T& omega) {
        using std::cos;
        using std::sin;
        state_ = {{theta, T(0)}, {omega, T(0)}, {sin(theta), T(0)}, {cos(theta), T(0)}};
    }

    const flow_state<T>& state() const { return state_; }

    /// The state at time + i imaginary, by the straight line from the time of the last call.
    const flow_state<T>& advance_to(const T& time, const T& imaginary = T(0)) {
        const complex_number<T> target{time, imaginary};
        while (true) {
            const complex_number<T> way = target - now_;
            const T length = modulus_of(way);
            const bool real = way.im == 0 && state_.omega.im == 0 && state_.sine.im == 0 && state_.cosine.im == 0;
            const system_series series = expand(real);
            const T step = step_of(series);
            if (!(step < length)) {
                state_ = at(series, way);
                now_ = target;
                return state_;
            }
            const complex_number<T> part = way * T(step / length);
            state_ = at(series, part);
            now_ = now_ + part;
        }
    }

private:
    struct system_series {
        complex_series<T> theta;
        complex_series<T> omega;
        complex_series<T> sine;
        complex_series<T> cosine;
    };

    system_series expand(bool real) const {
        const int order = static_cast<int>(decimal_digits(digits<T>()) * 11 / 10) + 10;
        system_series s{{state_.theta, real}, {state_.omega, real}, {state_.sine, real}, {state_.cosine, real}};
        for (int n = 0; n < order; ++n) {
            const T power(n + 1);
            const complex_number<T> sine_slope = product_coefficient(s.cosine, s.omega, n);
            const complex_number<T> cosine_slope = -product_coefficient(s.sine, s.omega, n);
            s.theta.push_back(s.omega[n] / power);
            s.omega.push_back(-s.sine[n] / power);
            s.sine.push_back(sine_slope / power);
            s.cosine.push_back(cosine_slope / power);
        }
        return s;
    }

    // h with |omega_n| h^n <= epsilon for the last four n: about R e^-2.
    static T step_of(const system_series& s) {
        using std::exp;
        using std::log;
        const int order = s.omega.order();
        T largest(0);
        for (int n = order - 3; n <= order; ++n) {
            largest = std::max(largest, modulus_of(s.omega[n]));
        }
        return largest == 0 ? T(1) : T(exp((log(epsilon<T>()) - log(largest)) / order));
    }

    static flow_state<T> at(const system_series& s, const complex_number<T>& time) {
        return {evaluate(s.theta, time), evaluate(s.omega, time), evaluate(s.sine, time), evaluate(s.cosine, time)};
    }

    flow_state<T> state_;
    complex_number<T> now_;
};

}  // namespace libration
