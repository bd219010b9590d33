// The exact motion: initial conditions of theta'' + sin theta = 0 as given, with every decision about them (regime,
// direction, winding, symmetric initial point) already made exactly. A plain value without template parameter: all
// scalars compute from the same motion.
#pragma once

#include <algorithm>
#include <optional>

#include "libration/pendulum/decision.hpp"
#include "libration/pendulum/regime.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// A motion of the pendulum, dimensionless unless a length and a gravity are given: then its times are seconds and
/// its angular velocities rad/s, t = t_dimensionless sqrt(length/gravity). The energy is always in units of m g l.
class motion {
public:
    /// The canonical motion of energy E: from rest at +arccos(1-E) below 2; from the top (pi, +-sqrt(2E-4)) above; from
    /// the bottom (0, +-2) at 2. direction is +1 or -1. Throws error for a negative energy, libration::error
    /// of kind undecided if no precision shows the sign of E or of 2 - E.
    static motion of_energy(const exact& energy, int direction = 1);
    static motion of_energy(const rational& energy, int direction = 1) { return of_energy(exactly(energy), direction); }

    /// Energy E from the angle theta0, omega0 = direction * sqrt(2(E - 1 + cos theta0)).
    /// Throws as of_energy(), and error when the energy does not reach theta0.
    static motion of_energy_from(const exact& energy, const exact& theta0, int direction = 1);
    static motion of_energy_from(const rational& energy, const exact& theta0, int direction = 1) {
        return of_energy_from(exactly(energy), theta0, direction);
    }

    /// From the angle theta0 with angular velocity omega0; squared frequency is gravity/length in the units of omega0
    /// squared. Throws error for an omega0 that is a bare fraction of pi, error of the kind undecided if no
    /// precision shows the regime.
    static motion of_state(const exact& theta0, const exact& omega0, const exact& squared_frequency = exactly(1));
    static motion of_state(const exact& theta0, const exact& omega0, const rational& squared_frequency) {
        return of_state(theta0, omega0, exactly(squared_frequency));
    }

    /// The same motion in units of a pendulum of this gravity/length: times in seconds.
    motion with_squared_frequency(const exact& squared_frequency) const {
        motion result = *this;
        result.squared_frequency_ = squared_frequency;
        return result;
    }
    motion with_squared_frequency(const rational& squared_frequency) const {
        return with_squared_frequency(exactly(squared_frequency));
    }

    pendulum::regime regime() const { return regime_; }
    /// +1 counterclockwise, -1 clockwise, for rotation and separatrix.
    int direction() const { return direction_; }
    /// Sign of omega0.
    int omega0_sign() const { return omega0_sign_; }
    /// The whole turns in theta0: the motion oscillates about, or starts next to, 2 pi turns().
    const integer& turns() const { return turns_; }
    /// E if it is rational: always for motions given by energy, and for angles with a rational cosine.
    const std::optional<rational>& energy() const { return energy_; }
    /// theta0 as given, if it was given.
    const std::optional<exact>& theta0() const { return theta0_; }
    /// E and 2-E as exact numbers: if E was given, and if it is rational or follows from a formula.
    const std::optional<exact>& exact_energy() const { return exact_energy_; }
    const std::optional<exact>& exact_gap() const { return exact_gap_; }
    /// omega0^2, dimensionless, if it is rational.
    std::optional<rational> omega0_squared() const {
        return exact_omega0_squared_ && exact_omega0_squared_->is_fraction()
                   ? std::optional(exact_omega0_squared_->coefficient)
                   : std::nullopt;
    }
    /// omega0^2, dimensionless, if it is an exact number that was given.
    const std::optional<exact>& exact_omega0_squared() const { return exact_omega0_squared_; }
    /// gravity/length.
    const exact& squared_frequency() const { return squared_frequency_; }
    /// If the motion starts exactly on a symmetric point: 0 bottom, 1 top, 2 the opposite passage of the bottom, -1 or
    /// 3 the opposite top; the phase of the initial point in units of T*, counted in the direction of motion (the
    /// clockwise canonical rotation starts at -1).
    const std::optional<int>& start_quarter() const { return quarter_; }
    /// Bits that may cancel in the computation of E, 2-E and the initial point from the given numbers.
    long condition_bits() const { return condition_bits_ + turn_bits_; }

private:
    motion() = default;

    void note_condition(long exponent) {
        if (exponent != exponent_of_zero) {
            condition_bits_ = std::max(condition_bits_, -exponent);
        }
    }

    void set_energy(const exact& energy);
    void set_energy_and_gap(exact energy, exact gap);
    void set_angle(const exact& theta0);
    void set_omega0_squared(exact squared);
    // E of an initial state whose energy is not a fraction.
    void set_energy_of_start(const exact& kinetic);
    // Regime and symmetric initial point from the signs of 2-E, of omega0 and of theta0 - 2 pi turns.
    void finish();
    void place_symmetric_start();

    pendulum::regime regime_ = pendulum::regime::libration;
    int direction_ = 1;
    int omega0_sign_ = 0;
    integer turns_ = 0;
    proved_sign gap_;
    proved_sign rest_;
    std::optional<rational> energy_;
    std::optional<exact> exact_energy_;
    std::optional<exact> exact_gap_;
    std::optional<exact> theta0_;
    std::optional<exact> exact_omega0_squared_;
    exact squared_frequency_ = exactly(1);
    std::optional<int> quarter_;
    long condition_bits_ = 0;  // of E, 2-E, omega0 and theta0 - 2 pi turns
    long turn_bits_ = 0;       // of the turns, in addition to each of them
};

}  // namespace libration::pendulum
