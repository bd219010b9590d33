// theta and omega of any motion by Arb's theta functions and Carlson's integral, for the attack: it uses only the
// library's class of balls and its reader of numbers.
#pragma once

#include <utility>

#include "libration/number/exact.hpp"
#include "truncation/arb_theta.hpp"

namespace libration::tests {

struct state_of_route {
    ball theta;
    ball omega;
};

/// A motion from the top (E < 2: theta_max, E > 2: pi, counterclockwise), E and 2-E exact.
class route_from_top {
public:
    route_from_top(const rational& energy, const rational& gap)
        : rotates_(gap < 0),
          rate_(rotates_ ? sqrt(from_rational<ball>(rational(energy / 2))) : ball(1)),
          k_(rotates_ ? 1 / rate_ : sqrt(from_rational<ball>(rational(energy / 2)))),
          complement_(sqrt(from_rational<ball>(rotates_ ? rational(-gap / energy) : rational(gap / 2)))),
          functions_(k_, complement_) {}

    /// T, for a rotation that of one turn.
    ball period() const { return functions_.period() * (rotates_ ? 2 : 4) / rate_; }

    /// At a time given as a number of periods.
    state_of_route at(const ball& periods) const {
        const integer whole = nearest_integer(periods);
        const ball part = periods - from_rational<ball>(rational(whole));
        const auto [cd, sd, nd] = functions_.over_dn(rotates_ ? part : part * 2);
        if (rotates_) {
            // theta = 2 am(u + K), whose sine is cd and whose cosine is -k' sd; omega = 2 rate dn(u + K).
            const ball turned = pi<ball>() * from_rational<ball>(rational(whole * 2));
            return {atan2(complement_ * sd, cd) * 2 + pi<ball>() + turned, complement_ * nd * rate_ * 2};
        }
        // sin(theta/2) = k cd u, cos(theta/2) = k' nd u, omega = 2 k cn(u + K).
        return {atan2(k_ * cd, complement_ * nd) * 2, -(k_ * complement_ * sd) * 2};
    }

private:
    bool rotates_;
    ball rate_;
    ball k_;
    ball complement_;
    arb_jacobi functions_;
};

/// From an initial state with |theta0| < pi and omega0 > 0, not at E = 2.
inline state_of_route route_from_start(const rational& theta0, const rational& omega0, const rational& time) {
    const ball half = from_rational<ball>(rational(theta0 / 2));
    const ball speed = from_rational<ball>(omega0);
    const ball sine = sin(half);
    const ball energy_half = sine * sine + speed * speed / 4;
    const bool rotates = certainly_less(ball(1), energy_half);
    const ball rate = rotates ? sqrt(energy_half) : ball(1);
    const ball parameter = rotates ? 1 / energy_half : energy_half;
    const ball k = sqrt(parameter);
    const ball gap_half = cos(half) * cos(half) - speed * speed / 4;  // 1 - E/2
    const ball complement = sqrt(rotates ? -gap_half / energy_half : gap_half);
    const arb_jacobi functions(k, complement);
    const ball amplitude = rotates ? half : atan2(sine, speed / 2);
    const ball u = arb_incomplete(amplitude, parameter) + from_rational<ball>(time) * rate;
    const ball quarters = u / functions.period();
    const integer whole = nearest_integer(quarters / (rotates ? 2 : 4));
    const ball part = quarters - from_rational<ball>(rational(whole * (rotates ? 2 : 4)));
    const auto at = functions(ball(part * functions.period()));
    if (rotates) {
        const ball turned = pi<ball>() * from_rational<ball>(rational(whole * 2));
        return {atan2(at.sn, at.cn) * 2 + turned, at.dn * rate * 2};
    }
    return {atan2(k * at.sn, at.dn) * 2, k * at.cn * 2};
}

}  // namespace libration::tests
