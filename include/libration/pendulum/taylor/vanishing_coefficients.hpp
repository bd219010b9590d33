// Which Taylor coefficients of theta are exactly 0: no ball ever decides that.
//
// At a point with rational E and cos theta_0, let s = sin theta_0 and v = omega_0, whose squares are rational:
// s^2 = 1 - cos^2 theta_0, v^2 = 2(E - 1 + cos theta_0). D = cos theta - cos theta_0 and w = omega satisfy
//     D'' = A + B D - 3 D^2,   w'' = -(cos theta_0 + D) w,   D_1 = -s v,  w_0 = v,  w_1 = -s,  n a_n = w_{n-1},
// with rational A = s^2 - v^2 cos theta_0 and B = 2(1-E) - 6 cos theta_0. By induction D_n is a fraction for even n and
// s v times one for odd n; w_n is v times a fraction for even n and s times one for odd n, because (s v)(s v) = s^2
// v^2, (s v) s = s^2 v and (s v) v = v^2 s. So a_n = 0 exactly where its unit (v or s) or its fraction is 0.
#pragma once

#include <optional>
#include <vector>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/motion/motion.hpp"

namespace libration {

/// For n = 0 .. N whether a_n, n >= 1, is exactly 0 about a point with this energy and this cosine of theta, where
/// omega^2 = 2(E - 1 + cosine) >= 0; false for a_0. O(N^2) operations on fractions that grow like N digits: for the few
/// cases where a ball keeps containing 0.
inline std::vector<bool> vanishing_coefficients(const rational& energy, const rational& cosine, int order) {
    const rational sine_squared = 1 - cosine * cosine;
    const rational speed_squared = (energy - 1 + cosine) * 2;
    const rational constant = sine_squared - cosine * speed_squared;
    const rational linear = (1 - energy) * 2 - cosine * 6;
    const auto length = static_cast<std::size_t>(order) + 2;
    std::vector<rational> d(length, rational(0));  // in units of 1 and s v
    std::vector<rational> w(length, rational(0));  // in units of v and s
    d[1] = w[1] = -1;
    w[0] = 1;
    for (std::size_t n = 0; n + 2 < length; ++n) {
        const bool even = n % 2 == 0;
        rational square = 0;
        rational product = 0;
        for (std::size_t k = 0; k <= n; ++k) {
            const bool of_odd = k % 2 != 0;
            square += of_odd && even ? rational(d[k] * d[n - k] * sine_squared * speed_squared) : d[k] * d[n - k];
            product += !of_odd ? d[k] * w[n - k] : d[k] * w[n - k] * (even ? sine_squared : speed_squared);
        }
        const rational divisor = static_cast<long>((n + 1) * (n + 2));
        d[n + 2] = ((n == 0 ? constant : rational(0)) + linear * d[n] - square * 3) / divisor;
        w[n + 2] = -(cosine * w[n] + product) / divisor;
    }
    std::vector<bool> vanishes(static_cast<std::size_t>(order) + 1, false);
    for (std::size_t n = 1; n < vanishes.size(); ++n) {
        vanishes[n] = w[n - 1] == 0 || (n % 2 != 0 ? speed_squared == 0 : sine_squared == 0);
    }
    return vanishes;
}

/// cos theta at the symmetric point `quarter` of a motion of rational energy: 1 at the bottom, -1 at the top of
/// rotation, 1 - E at that of libration.
inline std::optional<rational> rational_cosine_at(const motion& m, const integer& quarter) {
    if (!m.energy() || m.regime() == regime::unstable_equilibrium) {
        return std::nullopt;
    }
    if (quarter_of_four(quarter) % 2 == 0) {
        return rational(1);
    }
    return m.regime() == regime::rotation ? rational(-1) : rational(1 - *m.energy());
}

/// cos theta0 of the start of a motion of rational energy, where it is rational.
inline std::optional<rational> rational_cosine_at_start(const motion& m) {
    return m.energy() && m.theta0() ? rational_cosine(*m.theta0()) : std::nullopt;
}

}  // namespace libration
