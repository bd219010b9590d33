// The pendulum's equation integrated along straight lines in the complex t-plane, by Taylor series of the equation
// alone: no elliptic function, no period, no known singularity. Used to check the results about those.
#pragma once

#include <algorithm>
#include <utility>

#include "libration/scalar/complex_number.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// theta, omega, sin theta and cos theta: their values at one instant, or their series about it.
template <class V>
struct flow_variables {
    V theta;
    V omega;
    V sine;
    V cosine;
};
template <scalar T>
using flow_state = flow_variables<complex_number<T>>;

/// A motion of theta'' + sin theta = 0 as the system of four equations [Fairen1988]
///     theta' = omega,  omega' = -s,  s' = c omega,  c' = -s omega,
/// whose right-hand sides are polynomials. A step uses 11/10 as many powers as the precision has digits, plus 10, and
/// is as long as the last of them allow. It never ends on a path through a singularity. Errors: some epsilon per step,
/// amplified by the flow itself (like e^t near the top).
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
        bool arrived = false;
        while (!arrived) {
            const complex_number<T> path = target - now_;
            const bool real = path.im == 0 && state_.omega.im == 0 && state_.sine.im == 0 && state_.cosine.im == 0 &&
                              state_.theta.im == 0;
            arrived = real ? step<T>(path) : step<complex_number<T>>(path);
        }
        now_ = target;
        return state_;
    }

private:
    // One step along the path, over the real numbers if everything is real, which saves three of four products. Returns
    // whether it was the last.
    template <field R>
    bool step(const complex_number<T>& path) {
        const auto series = expand<R>();
        const T length = modulus_of(path);
        const T longest = longest_step(series.omega);
        const bool last = !(longest < length);
        const complex_number<T> part = last ? path : path * T(longest / length);
        const auto value = [&](const series::power_series<R>& a) {
            return complex_of(evaluate_value(a, number_of<R>(part)));
        };
        state_ = {value(series.theta), value(series.omega), value(series.sine), value(series.cosine)};
        now_ = now_ + part;
        return last;
    }

    template <field R>
    flow_variables<series::power_series<R>> expand() const {
        const int order = static_cast<int>(decimal_digits(digits<T>()) * 11 / 10) + 10;
        const auto from = [&](const complex_number<T>& value) {
            auto a = series::power_series<R>::zero(order);
            a[0] = number_of<R>(value);
            return a;
        };
        flow_variables<series::power_series<R>> s{from(state_.theta), from(state_.omega), from(state_.sine),
                                                  from(state_.cosine)};
        for (int n = 0; n < order; ++n) {
            s.theta[n + 1] = s.omega[n] / (n + 1);
            s.omega[n + 1] = -s.sine[n] / (n + 1);
            s.sine[n + 1] = product_coefficient(s.cosine, s.omega, n) / (n + 1);
            s.cosine[n + 1] = -product_coefficient(s.sine, s.omega, n) / (n + 1);
        }
        return s;
    }

    // h with |omega_n| h^n <= epsilon for the last four n: about R e^-2.
    template <field R>
    static T longest_step(const series::power_series<R>& omega) {
        using std::exp;
        using std::log;
        const int order = omega.order();
        T largest(0);
        for (int n = order - 3; n <= order; ++n) {
            largest = std::max(largest, modulus_of(complex_of(omega[n])));
        }
        return largest == 0 ? T(1) : T(exp(T((log(epsilon<T>()) - log(largest)) / order)));
    }

    template <field R>
    static R number_of(const complex_number<T>& z) {
        if constexpr (std::same_as<R, T>) {
            return z.re;
        } else {
            return z;
        }
    }
    static complex_number<T> complex_of(const T& x) { return {x, T(0)}; }
    static complex_number<T> complex_of(const complex_number<T>& z) { return z; }

    flow_state<T> state_;
    complex_number<T> now_;
};

}  // namespace libration
