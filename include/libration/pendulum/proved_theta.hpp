// theta of the canonical motion to any number of places, proved, and its sensitivity to the last digit of the energy.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "libration/digits/proved_decimals.hpp"
#include "libration/pendulum/proved_canonical.hpp"
#include "libration/pendulum/variation.hpp"

namespace libration::pendulum {

/// theta at an exact time of the canonical motion of energy E, 2-E = gap [DLMF 22.19.2], with a radius below
/// 10^-places: the guard digits are doubled until that holds. Independent of the current precision; the result has its
/// own. Cost: that of a proved_canonical, a few times. Throws as landen_motion, and error of the kind undecided if
/// most_guard_digits more do not suffice for the proof.
inline ball proved_theta(const rational& energy, const rational& gap, const rational& time, long places) {
    const auto attempt = [&](const precision_run& /*run*/) -> std::optional<ball> {
        const proved_canonical motion(energy, gap);
        ball theta = motion.theta_at(motion.phase_at(time));
        return certainly_less(radius_of(theta), pow(ball(10), -places)) ? std::optional(std::move(theta))
                                                                        : std::nullopt;
    };
    return with_growing_precision(proving(places),
                                  "theta at " + time.str() + " to " + std::to_string(places) + " places", attempt);
}

/// |d theta/dE| E/max(1, |theta|) at a fixed time: the relative change of the energy times this is the change of theta
/// in units of max(1, |theta|). From the variation of the motion (variation.hpp) with 40 digits more than cancel in it;
/// heuristic, and without correct digits where the derivative vanishes. Cost: one value of theta and omega, and a chain
/// of moduli. Throws as landen_motion.
inline mpfr energy_condition(const rational& energy, const rational& gap, const rational& time) {
    const motion m = motion::of_energy(energy);
    const exact instant = exactly(time);
    const long before_point = time == 0 ? 0 : std::max(0L, binary_exponent(from_rational<mpfr>(time)));
    const precision_scope scope(40 + decimal_digits(m.condition_bits() + 2 * before_point));
    const proved_canonical proved(energy, gap);
    const enclosed_state state = proved.state_at(proved.phase_at(time));
    const mpfr theta = midpoint_of(state.theta);
    const auto at = variation<mpfr>(m).at(from_exact<mpfr>(instant), theta, midpoint_of(state.omega));
    const mpfr unit = abs(theta) < 1 ? mpfr(1) : mpfr(abs(theta));
    return abs(at.phi) * from_rational<mpfr>(energy) / unit;
}

}  // namespace libration::pendulum
