// The phase computed from rounded times, as in a program without exact times: the error that the phase map avoids.
#pragma once

#include <algorithm>
#include <utility>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The phase of a motion that starts at a top or a bottom, by the remainder of the rounded time and the rounded period,
/// fmod(t, T) [paper (newseries), the modulo]. The remainder itself is exact, but t and T each have an error of up to
/// half an epsilon of themselves, and that of T counts once per period: at time t the phase is off by up to epsilon t.
template <fixed_scalar T>
class rounded_phase_map {
public:
    /// Throws error at E = 2, and for an initial point between the quarters.
    explicit rounded_phase_map(motion m) : motion_(std::move(m)) {
        if (!motion_.start_quarter()) {
            throw error(error_kind::argument, "motion", "", "starts neither at a top nor at a bottom");
        }
        const precision_scope scope(decimal_digits(digits<T>() + 64));
        period_ = narrow<T>(effective_period(energy_level_of<mpfr>(motion_)) * quarters_per_period(motion_.regime()));
    }

    /// The phase at a time, less whole periods.
    phase<T> at(const exact& time) const {
        using std::fmod;
        const T rest = fmod(rounded(time), period_);
        const T effective_period = period_ / quarters_per_period(motion_.regime());
        const integer quarters = nearest_integer(widen(T(rest / effective_period)));
        const T offset = rest - from_rational<T>(rational(quarters)) * effective_period;
        return {quarters + *motion_.start_quarter(), offset, offset > 0 ? 1 : offset < 0 ? -1 : 0};
    }

private:
    T rounded(const exact& time) const {
        const precision_scope scope(decimal_digits(digits<T>() + 64));
        return narrow<T>(dimensionless_time<mpfr>(motion_, time));
    }

    motion motion_;
    T period_ = T(0);
};

/// sqrt(2E) (p + 1) T epsilon: the largest error of theta by the rounding of t and T within the period after p
/// whole ones, to first order; half of it by t, half by T.
template <fixed_scalar T>
mpfr rounded_phase_map_bound(const exact& energy, const integer& periods) {
    const energy_level<mpfr> o = energy_level_of<mpfr>(motion::of_energy(energy));
    const mpfr latest =
        effective_period(o) * quarters_per_period(o.regime) * from_rational<mpfr>(rational(periods + 1));
    return sqrt(mpfr(o.pair.energy * 2)) * latest * widen(epsilon<T>());
}

/// A phase with the whole periods removed from its quarter.
template <class T>
phase<T> within_period(phase<T> p, regime r) {
    const int in_period = quarters_per_period(r);
    integer rest = p.quarter % in_period;
    p.quarter = rest < 0 ? integer(rest + in_period) : rest;
    return p;
}

/// |a - b|, for rotation between angles that may differ by whole turns.
inline mpfr angle_between(const mpfr& a, const mpfr& b, regime r) {
    const mpfr difference = a - b;
    const mpfr turn = pi<mpfr>() * 2;
    const integer turns = r == regime::rotation ? nearest_integer(mpfr(difference / turn)) : integer(0);
    return abs(mpfr(difference - from_rational<mpfr>(rational(turns)) * turn));
}

/// The largest |error| of theta, up to whole turns, over times near (p + i/points) T, i = 0 .. points, given with
/// 20 decimals: of the exact solution in T at the phases computed by a clock, compared with the exact solution in mpfr.
/// The motion is the canonical one of an energy. At the current working precision. Throws error at E = 2.
template <fixed_scalar T, class Clock>
mpfr phase_map_error(const exact& energy, const Clock& clock, const integer& periods, int points) {
    const motion m = motion::of_energy(energy);
    const exact_solution<T> rounded(m);
    const exact_solution<mpfr> truth(m);
    const mpfr period = effective_period(energy_level_of<mpfr>(m)) * quarters_per_period(m.regime());
    const integer decimals = boost::multiprecision::pow(integer(10), 20U);
    mpfr worst(0);
    for (int i = 0; i <= points; ++i) {
        const rational count = rational(periods) + rational(i, points);
        const mpfr scaled = period * from_rational<mpfr>(rational(count * rational(decimals)));
        const exact time = exactly(rational(nearest_integer(scaled), decimals));
        const mpfr found = widen(rounded.at(within_period(clock.at(time), m.regime())).theta);
        const mpfr expected = truth.at(within_period(truth.phases().at(time), m.regime())).theta;
        worst = std::max(worst, angle_between(found, expected, m.regime()));
    }
    return worst;
}

}  // namespace libration::pendulum
