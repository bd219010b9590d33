// How much theta moves when the numbers that were typed move: what no program can be blamed for.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "libration/pendulum/proved_motion.hpp"
#include "libration/pendulum/typed_motion.hpp"

namespace libration {

/// A motion with its neighbours, one for each number that gives it, for
///     condition = (|t omega| + sum_x |x dtheta/dx|) / max(1, |theta|),
/// x the typed numbers: when each of them, and t, is off by a relative epsilon, theta is off by up to condition * epsilon *
/// max(1, |theta|) to first order; a number that is 0 is taken as exact. The derivatives are difference quotients over a
/// relative step 2^-s, s half the bits of the working precision less those of t: their error is of relative size
/// 2^-s t/gap, so that bits_for() makes three digits right. That is a heuristic; it fails next to a turning point in time
/// of the starts themselves, and where theta hardly depends on the inputs. Infinite where theta is no differentiable
/// function of the inputs: energy 2 from its canonical start, which jumps there, and a start at rest by energy and theta0.
class conditioned_motion {
public:
    /// At the working precision. Throws as typed_motion::motion and proved_motion.
    conditioned_motion(const typed_motion& typed, const libration::motion& m)
        : motion_(m), step_bits_(digits<ball>() / 2), differentiable_(is_differentiable(typed, m)) {
        if (differentiable_) {
            add_neighbours(typed);
        }
    }

    const proved_motion& of() const { return motion_; }

    /// The bits that three digits of the condition at a time of this binary exponent need.
    static long bits_for(const libration::motion& m, long time_exponent) {
        const long growth = at_critical_energy(m.regime()) ? 3L << std::clamp(time_exponent, 0L, longest_growth) : 0;
        return 2 * (40 + m.condition_bits() + std::max(0L, time_exponent) + growth);
    }

    /// The condition at a time, for the state there; nothing where it is infinite or beyond e^1000.
    std::optional<mpfr> at(const exact& time, const enclosed_state& state) const {
        const ball elapsed = dimensionless_time<ball>(motion_.of(), time) * time_unit<ball>(motion_.of());
        if (!differentiable_ ||
            (at_critical_energy(motion_.of().regime()) && binary_exponent(elapsed) > longest_growth)) {
            return std::nullopt;
        }
        ball sum = abs(ball(elapsed * state.omega));
        for (const proved_motion& neighbour : neighbours_) {
            sum += ldexp(abs(ball(neighbour.at(time).theta - state.theta)), step_bits_);
        }
        const mpfr size = abs(midpoint_of(state.theta));
        return mpfr(midpoint_of(sum) / (size > 1 ? size : mpfr(1)));
    }

private:
    static constexpr long longest_growth = 10;

    static bool is_differentiable(const typed_motion& typed, const libration::motion& m) {
        const bool jumps = !typed.theta0 && typed.energy && at_critical_energy(m.regime());
        const bool rests = typed.theta0 && !typed.omega0 && m.omega0_sign() == 0;
        return !jumps && !rests;
    }

    void add_neighbours(const typed_motion& typed) {
        const rational factor = 1 + power_of(2, -step_bits_);
        for (const member each : moved_members(typed)) {
            typed_motion moved = typed;
            exact& number = *(moved.*each);
            if (!number.is_zero()) {
                number.coefficient *= factor;
                neighbours_.emplace_back(moved.motion());
            }
        }
    }

    using member = std::optional<exact> typed_motion::*;
    static std::vector<member> moved_members(const typed_motion& typed) {
        const member speed = typed.omega0 ? &typed_motion::omega0
                             : typed.gap  ? &typed_motion::gap
                                          : &typed_motion::energy;
        return typed.theta0 ? std::vector<member>{&typed_motion::theta0, speed} : std::vector<member>{speed};
    }

    proved_motion motion_;
    long step_bits_;
    bool differentiable_;
    std::vector<proved_motion> neighbours_;
};

}  // namespace libration
