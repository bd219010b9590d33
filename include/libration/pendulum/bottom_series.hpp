// The Taylor series of theta about the bottom of the trajectory, which the paper shows to diverge before the top.
#pragma once

#include <algorithm>
#include <vector>

#include "libration/pendulum/expansion.hpp"

namespace libration::pendulum {

/// The motion of this energy that is at its lowest point at t = 0: libration passing theta = 0 with omega = -sqrt(2E),
/// as the one released at +theta_max at time T*, rotation counterclockwise at theta = 2 pi [paper fig:series]. E = 2
/// starts as libration.
inline motion motion_from_bottom(const exact& energy) {
    const bool rotates = sign_of_exact(energy - exactly(2)) > 0;
    return motion::of_energy_from(energy, read_exact(rotates ? "2pi" : "0"), rotates ? 1 : -1);
}

/// The partial sums about the bottom up to an order, and the exact angle. Not for E = 0 and 2.
template <scalar T>
class bottom_series {
public:
    /// O(order^2). Throws error for a negative order and at E = 2.
    bottom_series(const exact& energy, int order)
        : exact_(motion_from_bottom(energy)),
          effective_period_(pendulum::effective_period(energy_level_of<T>(exact_.of()))),
          about_(expand(exact_, {expansion_point::place::start, {}}, order)) {}

    const T& effective_period() const { return effective_period_; }
    T period() const { return effective_period_ * quarters_per_period(exact_.of().regime()); }
    /// The radius of convergence: K~', the nearest singularities being right above and below the bottom.
    const T& radius() const { return about_.scale; }

    /// The angle at an exact time since the bottom, unwrapped.
    T theta(const exact& time) const { return exact_(time).theta; }

    /// An exact time as a number.
    T dimensionless(const exact& time) const {
        if (!time.has_periods()) {
            return from_exact<T>(time);
        }
        const T whole = from_rational<T>(time.periods()) * period();
        return time.only_periods() ? whole : T(whole + from_exact<T>(time.without_periods()));
    }

    /// sum_{n=0}^{N} a_n t^n, N up to the order: theta is odd about the bottom, so by Horner's rule in t^2. Beyond the
    /// radius the last terms are the largest: the precision is relative to them. O(N).
    T partial_sum(int order, const T& t) const {
        const T x = t / about_.scale;
        const T square = x * x;
        T sum(0);
        for (int n = order % 2 == 0 ? order - 1 : order; n > 0; n -= 2) {
            sum = sum * square + about_.scaled[n];
        }
        return about_.scaled[0] + sum * x;
    }

private:
    exact_solution<T> exact_;
    T effective_period_;
    expansion<T> about_;
};

/// Decimal digits by which the errors of order N at these times are below theta: inside the radius they decrease like
/// (t/R)^N. N^2 and a few digits for the constants are added.
inline long bottom_digits_below(const exact& energy, int order, const std::vector<exact>& times) {
    const precision_scope scope(20);
    const bottom_series<mpfr> bottom(energy, 0);
    mpfr nearest = bottom.radius();
    for (const exact& time : times) {
        const mpfr t = abs(bottom.dimensionless(time));
        nearest = t > 0 && t < nearest ? t : nearest;
    }
    const mpfr below = log10(mpfr(bottom.radius() / nearest)) * (order + 3) + log10(mpfr(order + 1)) * 2;
    return 25 + static_cast<long>(nearest_integer(below));
}

}  // namespace libration::pendulum
