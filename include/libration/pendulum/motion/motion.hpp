// The exact motion: initial conditions of theta'' + sin theta = 0 as typed, with every decision about them (regime,
// direction, winding, symmetric start) already taken exactly. A plain value without template parameter: all scalars
// compute from the same motion.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "libration/pendulum/motion/decision.hpp"
#include "libration/pendulum/motion/regime.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// A motion of the pendulum, dimensionless unless it was given a length and a gravity: then its times are seconds and
/// its angular velocities rad/s, t = t_dimensionless sqrt(length/gravity). The energy is always in units of m g l.
class motion {
public:
    /// The canonical motion of energy E: from rest at +arccos(1-E) below 2; from the top (pi, +-sqrt(2E-4)) above; from
    /// the bottom (0, +-2) at 2. direction is +1 or -1.
    static motion of_energy(const rational& energy, int direction = 1) {
        motion result;
        result.set_energy(energy);
        result.direction_ = direction;
        result.omega0_sign_ = direction;
        const rational above = energy - 2;
        if (energy == 0) {
            result.omega0_sign_ = 0;
            result.theta0_ = exact{};
        } else if (above == 0) {
            result.theta0_ = exact{};
            result.omega0_squared_ = rational(4);
        } else if (above > 0) {
            result.theta0_ = read_exact("pi");
            result.omega0_squared_ = rational(above * 2);
            result.quarter_ = direction;
        } else {
            result.omega0_sign_ = 0;
            result.omega0_squared_ = rational(0);
            result.quarter_ = 1;
        }
        if (energy == 0 || above == 0) {
            result.quarter_ = 0;
        }
        result.finish();
        return result;
    }

    /// Energy E from the angle theta0, omega0 = direction * sqrt(2(E - 1 + cos theta0)).
    /// Throws error when the energy does not reach theta0.
    static motion of_energy_from(const rational& energy, const exact& theta0, int direction = 1) {
        motion result;
        result.set_energy(energy);
        result.set_angle(theta0);
        // E - 1 + cos theta0 = omega0^2/2.
        const proved_sign kinetic =
            sign_of_sum_with_cosine(rational(energy - 1), theta0, "E - 1 + cos(" + theta0.text + ")");
        if (kinetic.sign < 0) {
            throw error(error_kind::argument, "theta0", theta0.text, "is not reached with this energy");
        }
        result.omega0_sign_ = kinetic.sign * direction;
        result.direction_ = direction;
        if (const auto cosine = rational_cosine(theta0)) {
            result.omega0_squared_ = rational((energy - 1 + *cosine) * 2);
        }
        result.note_condition(kinetic.exponent);
        result.finish();
        return result;
    }

    /// From the angle theta0 with angular velocity omega0, a fraction; stiffness is gravity/length in the units of
    /// omega0 squared. Throws error for an omega0 with pi in it, whose regime would not be decidable.
    static motion of_state(const exact& theta0, const exact& omega0, const rational& stiffness = 1) {
        if (omega0.measure != unit::one) {
            throw error(error_kind::argument, "omega0", omega0.text, "is not a decimal or a fraction");
        }
        motion result;
        result.stiffness_ = stiffness;
        result.set_angle(theta0);
        result.omega0_sign_ = omega0.coefficient.sign();
        result.direction_ = result.omega0_sign_ < 0 ? -1 : 1;
        result.omega0_squared_ = rational(omega0.coefficient * omega0.coefficient / stiffness);
        const rational kinetic = *result.omega0_squared_ / 2;
        if (const auto cosine = rational_cosine(theta0)) {
            result.set_energy(rational(1 - *cosine + kinetic));
        } else {
            result.gap_ = sign_of_sum_with_cosine(rational(1 - kinetic), theta0, "2 - E");
            const auto minus_energy = sign_of_sum_with_cosine(rational(-1 - kinetic), theta0, "E");
            result.note_condition(minus_energy.exponent);
            result.note_condition(result.gap_.exponent);
        }
        result.finish();
        return result;
    }

    /// The same motion in units of a pendulum of this gravity/length: times in seconds.
    motion with_stiffness(const rational& stiffness) const {
        motion result = *this;
        result.stiffness_ = stiffness;
        return result;
    }

    libration::regime regime() const { return regime_; }
    /// +1 counterclockwise, -1 clockwise, for rotation and separatrix.
    int direction() const { return direction_; }
    /// Sign of omega0.
    int omega0_sign() const { return omega0_sign_; }
    /// The whole turns in theta0: the motion swings about, or starts next to, 2 pi turns().
    const integer& turns() const { return turns_; }
    /// E where it is rational: always for motions given by energy, and for angles with a rational cosine.
    const std::optional<rational>& energy() const { return energy_; }
    /// theta0 as typed, where it was typed.
    const std::optional<exact>& theta0() const { return theta0_; }
    /// omega0^2, dimensionless, where it is rational.
    const std::optional<rational>& omega0_squared() const { return omega0_squared_; }
    /// gravity/length.
    const rational& stiffness() const { return stiffness_; }
    /// Where the motion starts exactly on a symmetric point: 0 bottom, 1 top, 2 the other way through the bottom, -1 or
    /// 3 the opposite top; the phase of the start in units of T*, counted in the direction of motion (the clockwise
    /// canonical rotation starts at -1).
    const std::optional<int>& start_quarter() const { return quarter_; }
    /// Bits that computing E, 2-E and the start from the typed numbers may cancel.
    long condition_bits() const { return condition_bits_ + turn_bits_; }

private:
    motion() = default;

    void note_condition(long exponent) {
        if (exponent != exponent_of_zero) {
            condition_bits_ = std::max(condition_bits_, -exponent);
        }
    }

    void set_energy(const rational& energy) {
        if (energy < 0) {
            throw error(error_kind::argument, "energy", energy.str(), "is a negative energy");
        }
        energy_ = energy;
        gap_ = sign_of(rational(2 - energy));
        note_condition(sign_of(energy).exponent);
        note_condition(gap_.exponent);
    }

    void set_angle(const exact& theta0) {
        theta0_ = theta0;
        const winding wound = wind(theta0);
        turns_ = wound.turns;
        rest_ = wound.rest;
        note_condition(rest_.exponent);
        if (turns_ != 0) {
            turn_bits_ = static_cast<long>(msb(integer(abs(turns_)))) + 4;
        }
    }

    // Regime and symmetric start from the signs of 2-E, of omega0 and of theta0 - 2 pi turns.
    void finish() {
        const bool at_rest = omega0_sign_ == 0;
        if (energy_ && *energy_ == 0) {
            regime_ = libration::regime::stable_equilibrium;
        } else if (gap_.sign > 0) {
            regime_ = libration::regime::libration;
        } else if (gap_.sign < 0) {
            regime_ = libration::regime::rotation;
        } else {
            regime_ = at_rest ? libration::regime::unstable_equilibrium : libration::regime::separatrix;
        }
        if (quarter_) {
            return;
        }
        const bool on_top = theta0_ && theta0_->measure != unit::one && denominator(theta0_->in_pi()) == 1 &&
                            numerator(theta0_->in_pi()) % 2 != 0;
        if (rest_.sign == 0) {
            quarter_ = regime_ == libration::regime::libration && omega0_sign_ < 0 ? 2 : 0;
        } else if (at_rest || (on_top && regime_ == libration::regime::rotation)) {
            // At a turning point, or rotating through the top: theta - 2 pi turns = direction * 2 am there.
            quarter_ = regime_ == libration::regime::rotation ? rest_.sign * direction_ : rest_.sign;
        }
    }

    libration::regime regime_ = libration::regime::libration;
    int direction_ = 1;
    int omega0_sign_ = 0;
    integer turns_ = 0;
    proved_sign gap_;
    proved_sign rest_;
    std::optional<rational> energy_;
    std::optional<exact> theta0_;
    std::optional<rational> omega0_squared_;
    rational stiffness_ = 1;
    std::optional<int> quarter_;
    long condition_bits_ = 0;  // of E, 2-E, omega0 and theta0 - 2 pi turns
    long turn_bits_ = 0;       // of the turns, which come on top of each of them
};

}  // namespace libration
