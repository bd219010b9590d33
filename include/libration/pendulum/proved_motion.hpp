// Any motion in balls: proved theta, omega, T* and R, each by the cheapest route applicable to the motion.
//
// If E is rational and the motion starts on a symmetric point (every motion given by its energy; from rest at
// 90deg), a few Landen steps on exact E and 2-E suffice: proved_canonical. Every other initial state needs an
// incomplete integral, and an energy such as 1 - cos 2.5 is itself a ball: exact_solution is used. At whole quarters
// from a symmetric start only the energy has to be computed, and a value that vanishes by symmetry is the number 0,
// which no precision could establish.
#pragma once

#include <optional>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/proved_canonical.hpp"
#include "libration/pendulum/singularities.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// One motion, any number of times, in the motion's units (seconds and rad/s if it has a length and a gravity). The
/// cost at a time is that of the route. Use it in a precision_scope of the size in which it was constructed; the parts
/// that need a wider one are recomputed. Throws precision_exhausted if the precision does not decide a branch.
class proved_motion {
public:
    explicit proved_motion(const motion& m) : motion_(m), seconds_(time_unit<ball>(m)) {
        if (at_rest() || (periodic() && m.energy() && m.start_quarter())) {
            if (!at_rest()) {
                engine_.emplace(*m.energy(), rational(2 - *m.energy()));
            }
            return;
        }
        solution_.emplace(m);
    }

    const motion& of() const { return motion_; }
    /// Whether theta is constant: E = 0, or at rest on top.
    bool at_rest() const {
        return motion_.regime() == regime::stable_equilibrium || motion_.regime() == regime::unstable_equilibrium;
    }
    /// Whether it is a libration or a rotation.
    bool periodic() const { return motion_.regime() == regime::libration || motion_.regime() == regime::rotation; }

    /// theta and omega at an exact time, which may be a multiple of T. 0 is the exact ball where symmetry implies it.
    /// Throws error for a multiple of T at E = 2.
    enclosed_state at(const exact& time) const {
        if (at_rest()) {
            return {from_exact<ball>(*motion_.theta0()), ball(0)};
        }
        const auto quarters = quarters_at(time);
        if (quarters && denominator(*quarters) == 1) {
            return at_quarter(numerator(*quarters));
        }
        if (!engine_) {
            const auto state = (*solution_)(time);
            return {state.theta, state.omega / seconds_};
        }
        return quarters ? at_part(*quarters) : at_number(time);
    }

    /// T*; in the limit E -> 0, pi/2. Throws error at E = 2.
    ball effective_period() const {
        if (engine_) {
            return pi<ball>() / (engine_->mean() * 2) * seconds_;
        }
        return pendulum::effective_period(energy_level_of<ball>(motion_)) * seconds_;
    }

    /// The radius of convergence about the top, sqrt(T*^2 + K~'^2) [paper (librationROC), (rotationROCgood)]; on the
    /// separatrix, which has no top, about the bottom, pi/2. Throws error at rest, where it is infinite.
    ball radius() const {
        if (at_rest()) {
            throw error(error_kind::argument, "motion", "", "is at rest: its radius of convergence is infinite");
        }
        if (!periodic()) {
            return pi<ball>() / 2 * seconds_;
        }
        const ball along = effective_period();
        const ball height = singularity_height(energy_level_of<ball>(motion_)) * seconds_;
        return sqrt(along * along + height * height);
    }

private:
    // Initial point and elapsed time in T* since the bottom, if both are exact.
    std::optional<rational> quarters_at(const exact& time) const {
        if (!periodic() || !motion_.start_quarter() || !time.only_periods()) {
            return std::nullopt;
        }
        return rational(time.coefficient * quarters_per_period(motion_.regime()) + *motion_.start_quarter());
    }

    // A whole number of T* after a passage through the bottom.
    enclosed_state at_quarter(const integer& quarter) const {
        const auto [energy, gap] = energies<ball>(motion_);
        const bool top = elliptic::quarter_of_four(quarter) % 2 != 0;
        if (motion_.regime() == regime::rotation) {
            const int d = motion_.direction();
            const ball speed = sqrt((top ? -gap : energy) * 2) * d;
            return {pi<ball>() * from_rational<ball>(rational(motion_.turns() * 2 + quarter * d)), speed / seconds_};
        }
        const int sign = elliptic::quarter_of_four(quarter) < 2 ? 1 : -1;
        const ball middle = whole_turns<ball>(motion_.turns());
        if (top) {
            return {middle + atan2(sqrt(energy), sqrt(gap)) * (2 * sign), ball(0)};
        }
        return {middle, sqrt(energy * 2) * sign / seconds_};
    }

    // A fraction of T* after the bottom: whole periods are subtracted exactly. The engine starts at the top, quarter 1.
    enclosed_state at_part(const rational& quarters) const {
        const int cycle = quarters_per_period(motion_.regime());
        const integer whole = nearest_integer(rational(quarters / cycle)) * cycle;
        const rational from_top = quarters - rational(whole) - 1;
        return placed(engine_->state_at(pi<ball>() * from_rational<ball>(rational(from_top / 2))), whole);
    }

    enclosed_state at_number(const exact& time) const {
        const int cycle = quarters_per_period(motion_.regime());
        const rational quarters = time.periods() * cycle;
        const integer whole = nearest_integer(rational(quarters / cycle)) * cycle;
        const ball z = engine_->mean() * (from_exact<ball>(time.without_periods()) / seconds_);
        const rational from_top = quarters - rational(whole) + *motion_.start_quarter() - 1;
        return placed(engine_->state_at(z + pi<ball>() * from_rational<ball>(rational(from_top / 2))), whole);
    }

    // From the canonical motion to this one; `whole` is the even number of quarters that rotation has gained.
    enclosed_state placed(const enclosed_state& canonical, const integer& whole) const {
        const ball middle = whole_turns<ball>(motion_.turns());
        if (motion_.regime() == regime::libration) {
            return {middle + canonical.theta, canonical.omega / seconds_};
        }
        const ball gained = pi<ball>() * from_rational<ball>(rational(whole));
        const int d = motion_.direction();
        return {middle + (canonical.theta + gained) * d, canonical.omega * d / seconds_};
    }

    motion motion_;
    ball seconds_;
    std::optional<proved_canonical> engine_;
    std::optional<exact_solution<ball>> solution_;
};

}  // namespace libration::pendulum
