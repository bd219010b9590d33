// Which Taylor coefficients of theta are exactly 0: balls can never decide that.
//
// At a point with rational E and cos theta_0, let s = sin theta_0 and v = omega_0, whose squares are rational:
// s^2 = 1 - cos^2 theta_0, v^2 = 2(E - 1 + cos theta_0). The recurrence of symmetric_squares.hpp starts from
//     D_1 = -s v,  w_0 = v,  w_1 = -s.
// If both are nonzero, in time scaled by s v, so that D_1 = -s^2 v^2, w_0 = v (s v) = s v^2, w_1 = -s (s v)^2, all D_n
// are fractions and all w_n are s times one. If one of them is 0, D_1 = 0 and, unscaled, w_n is the other times a
// fraction. So every w_n, and with it a_n = w_{n-1}/n, is 0 exactly if that fraction is.
#pragma once

#include <optional>
#include <vector>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/pendulum/symmetric_squares.hpp"

namespace libration::pendulum {

/// For n = 0 .. N whether a_n, n >= 1, is exactly 0 about a point with this energy and this cosine of theta, where
/// omega^2 = 2(E - 1 + cosine) >= 0; false for a_0. O(N^2) operations on fractions that grow like N digits: for the few
/// cases in which a ball contains 0 at every precision.
inline std::vector<bool> vanishing_coefficients(const rational& energy, const rational& cosine, int order) {
    const rational sine_squared = 1 - cosine * cosine;
    const rational speed_squared = (energy - 1 + cosine) * 2;
    const bool symmetric = sine_squared == 0 || speed_squared == 0;
    const rational h = symmetric ? rational(1) : rational(sine_squared * speed_squared);  // the square of the scale
    const rational constant = (sine_squared - cosine * speed_squared) * h;
    const rational linear = ((1 - energy) * 2 - cosine * 6) * h;
    symmetric_squares<rational> squares(order, series::parity::any);
    if (symmetric) {
        squares.w[0] = speed_squared == 0 ? 0 : 1;
        squares.w[1] = sine_squared == 0 ? 0 : -1;
    } else {
        squares.d[1] = -h;
        squares.w[0] = speed_squared;
        squares.w[1] = -h;
    }
    squares.solve(constant, linear, cosine, h);
    std::vector<bool> vanishes(static_cast<std::size_t>(order) + 1, false);
    for (int n = 1; n <= order; ++n) {
        vanishes[static_cast<std::size_t>(n)] = squares.w[n - 1] == 0;
    }
    return vanishes;
}

/// cos theta at the symmetric point `quarter` of a motion of rational energy: 1 at the bottom, -1 at the top of
/// rotation, 1 - E at that of libration.
inline std::optional<rational> rational_cosine_at(const motion& m, const integer& quarter) {
    if (!m.energy() || m.regime() == regime::unstable_equilibrium) {
        return std::nullopt;
    }
    if (elliptic::quarter_of_four(quarter) % 2 == 0) {
        return rational(1);
    }
    return m.regime() == regime::rotation ? rational(-1) : rational(1 - *m.energy());
}

/// cos theta0 of a motion of rational energy, if it is rational.
inline std::optional<rational> rational_cosine_at_start(const motion& m) {
    return m.energy() && m.theta0() ? rational_cosine(*m.theta0()) : std::nullopt;
}

}  // namespace libration::pendulum
