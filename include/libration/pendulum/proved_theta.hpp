// theta of the canonical motion to any number of places, proved, and how much it feels the last digit of the energy.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/pendulum/proved_canonical.hpp"

namespace libration {

/// theta at an exact time of the canonical motion of energy E, 2-E = gap [DLMF 22.19.2], with a radius below 10^-places:
/// the guard digits are doubled until that is so. Any precision may be in force; the result keeps its own. Cost: that of
/// a proved_canonical, a few times. Throws as landen_motion, and std::runtime_error where 20000 digits more do not prove it.
inline ball proved_theta(const rational& energy, const rational& gap, const rational& time, long places) {
    constexpr long most_guard = 20'000;
    for (long guard = 20; guard <= most_guard; guard *= 2) {
        const precision_scope scope(places + guard);
        try {
            const proved_canonical motion(energy, gap);
            ball theta = motion.theta_at(motion.phase_at(time));
            if (certainly_less(radius_of(theta), pow(ball(10), -places))) {
                return theta;
            }
        } catch (const precision_exhausted&) {
            continue;
        }
    }
    throw std::runtime_error("theta at " + time.str() + " is not proved to " + std::to_string(places) + " places");
}

/// |d theta/dE| E/max(1, |theta|) at a fixed time: the relative change of the energy times this is the change of theta
/// in units of max(1, |theta|). A centred difference with the step h = 10^-30 min(E, |2-E|), whose truncation is of the
/// order of 10^-60 of the result; heuristic, and without correct digits where the derivative vanishes. Cost: two values
/// of theta. Throws as proved_theta.
inline mpfr energy_condition(const rational& energy, const rational& gap, const rational& time) {
    constexpr unsigned step_digits = 30;
    const rational size = energy < abs(gap) ? energy : rational(abs(gap));
    const rational step = size / rational(boost::multiprecision::pow(integer(10), step_digits));
    const long step_places = decimal_digits(static_cast<long>(msb(integer(1 / step + 1))) + 1);
    const long places = step_places + 2L * step_digits;
    const ball above = proved_theta(rational(energy + step), rational(gap - step), time, places);
    const ball below = proved_theta(rational(energy - step), rational(gap + step), time, places);
    const precision_scope scope(places + 20);
    const mpfr theta = midpoint_of(above);
    const mpfr slope = abs(mpfr(midpoint_of(above) - midpoint_of(below))) / from_rational<mpfr>(rational(step * 2));
    const mpfr unit = abs(theta) < 1 ? mpfr(1) : mpfr(abs(theta));
    return slope * from_rational<mpfr>(energy) / unit;
}

}  // namespace libration
