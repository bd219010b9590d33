// Which Taylor coefficients of theta are exactly 0 though no symmetry makes them so: no ball ever decides that.
#pragma once

#include <optional>
#include <vector>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/motion.hpp"

namespace libration {

/// D = cos theta - cos theta_0 about a symmetric point and w = omega up to a factor, as exact fractions:
///     D'' = A + B D - 3 D^2,   w'' = -(cos theta_0 + D) w,   n a_n = w_{n-1}.
/// There sin theta_0 omega_0 = 0, so A = sin^2 theta_0 - cos theta_0 omega_0^2 and B = 2(1-E) - 6 cos theta_0 are fractions
/// with E, and D is even; w is even with w_0 = 1 or, at the top of libration, odd with w_1 = 1.
inline std::vector<rational> rational_velocity(const rational& energy, bool at_top, int order) {
    const bool turning = at_top && energy < 2;
    const rational cosine = turning ? rational(1 - energy) : rational(at_top ? -1 : 1);
    const rational speed_squared = turning ? rational(0) : rational((energy - 1 + cosine) * 2);
    const rational constant = 1 - cosine * cosine - cosine * speed_squared;
    const rational linear = (1 - energy) * 2 - cosine * 6;
    const auto length = static_cast<std::size_t>(order) + 2;
    std::vector<rational> d(length, rational(0));
    std::vector<rational> w(length, rational(0));
    w[turning ? 1 : 0] = 1;
    for (std::size_t n = 0; n + 2 < length; ++n) {
        rational square = 0;
        rational product = 0;
        for (std::size_t k = 0; k <= n; k += 2) {
            square += d[k] * d[n - k];
            product += d[k] * w[n - k];
        }
        const rational divisor = static_cast<long>((n + 1) * (n + 2));
        d[n + 2] = n % 2 == 0 ? rational(((n == 0 ? constant : rational(0)) + linear * d[n] - square * 3) / divisor)
                              : rational(0);
        w[n + 2] = -(cosine * w[n] + product) / divisor;
    }
    return w;
}

/// For n = 0 .. N whether a_n, n >= 1, is exactly 0, where that is decidable by fractions: about the symmetric point at
/// `quarter` of a motion of rational energy (the top at E = 1 has every second of its even coefficients 0, the top at
/// E = 5/2 has a_5 = 0). All false otherwise, for a_0, and without a quarter. O(N^2) operations on fractions that grow
/// like N digits: for the few cases where balls say that it may be needed.
inline std::vector<bool> vanishing_coefficients(const motion& m, const std::optional<integer>& quarter, int order) {
    std::vector<bool> vanishes(static_cast<std::size_t>(order) + 1, false);
    if (!quarter || !m.energy() || m.regime() == regime::unstable_equilibrium) {
        return vanishes;
    }
    const auto w = rational_velocity(*m.energy(), quarter_of_four(*quarter) % 2 != 0, order);
    for (std::size_t n = 1; n < vanishes.size(); ++n) {
        vanishes[n] = w[n - 1] == 0;
    }
    return vanishes;
}

}  // namespace libration
