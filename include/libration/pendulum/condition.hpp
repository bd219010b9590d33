// The change of theta per change of the given numbers: errors that no algorithm can avoid.
#pragma once

#include <algorithm>
#include <optional>

#include "libration/pendulum/proved_motion.hpp"
#include "libration/pendulum/typed_motion.hpp"
#include "libration/pendulum/variation.hpp"

namespace libration::pendulum {

/// A motion with its variation (variation.hpp), for
///     condition = (|t omega| + sum_x |x dtheta/dx|) / max(1, |theta|),
/// x the given numbers: if each of them, and t, has a relative error epsilon, theta has an error of up to condition *
/// epsilon * max(1, |theta|) to first order; a number equal to 0 is taken as exact, and a multiple of T varies with T.
/// The derivatives are closed forms in rounded arithmetic, in double if its 53 bits are enough, with bits_for() bits
/// for three correct digits: heuristic, and without correct digits if theta hardly depends on the inputs. Infinite
/// where theta is not a differentiable function of the inputs: energy 2 from its canonical initial state, which is
/// discontinuous there, and an initial state at rest by energy and theta0.
class conditioned_motion {
public:
    /// At the working precision. Throws as proved_motion.
    conditioned_motion(const typed_motion& typed, const pendulum::motion& m)
        : motion_(m), typed_(typed), differentiable_(is_differentiable(typed, m)) {
        if (differentiable_ && !motion_.at_rest()) {
            if (serves_double(m, 0)) {
                in_double_.emplace(m);
            } else {
                precise_.emplace(m);
            }
        }
    }

    const proved_motion& of() const { return motion_; }

    /// The bits needed for three digits of the condition at a time of this binary exponent.
    static long bits_for(const pendulum::motion& m, long time_exponent) {
        return 30 + m.condition_bits() + 2 * std::max(0L, time_exponent);
    }

    /// The condition at a time, for the state there; std::nullopt if it is infinite or beyond e^1000.
    std::optional<mpfr> at(const exact& time, const enclosed_state& state) const {
        const pendulum::motion& m = motion_.of();
        const auto elapsed = dimensionless_time<mpfr>(m, time);
        const long exponent = binary_exponent(elapsed);
        if (!differentiable_ || (at_critical_energy(m.regime()) && exponent > longest_growth)) {
            return std::nullopt;
        }
        const mpfr theta = midpoint_of(state.theta);
        const mpfr omega = midpoint_of(state.omega) * time_unit<mpfr>(m);
        const mpfr size = abs(theta);
        const mpfr of_time = abs(mpfr(elapsed * omega));
        mpfr of_numbers;
        if (motion_.at_rest()) {
            of_numbers = moved_at_rest(elapsed);
        } else {
            const mpfr share = share_of_periods(time, elapsed);
            if (in_double_ && serves_double(m, std::max(exponent, binary_exponent(size)))) {
                of_numbers = mpfr(moved(*in_double_, convert<double>(share), convert<double>(elapsed),
                                        convert<double>(theta), convert<double>(omega)));
            } else if (precise_) {
                of_numbers = moved(*precise_, share, elapsed, theta, omega);
            } else {
                of_numbers = moved(variation<mpfr>(m), share, elapsed, theta, omega);
            }
        }
        return mpfr((of_time + of_numbers) / (size > 1 ? size : mpfr(1)));
    }

private:
    static constexpr long longest_growth = 10;
    static constexpr long largest_energy = 1L << 40U;

    static bool is_differentiable(const typed_motion& typed, const pendulum::motion& m) {
        const bool jumps = !typed.theta0 && typed.energy && at_critical_energy(m.regime());
        const bool rests = typed.theta0 && !typed.omega0 && m.omega0_sign() == 0;
        return !jumps && !rests;
    }

    // Whether double suffices at a time, or an angle, of this binary exponent. Not outside its range of energies.
    static bool serves_double(const pendulum::motion& m, long exponent) {
        return !at_critical_energy(m.regime()) && bits_for(m, exponent) <= digits<double>() &&
               (m.energy() ? *m.energy() < largest_energy : !m.exact_energy() || is_moderate(*m.exact_energy()));
    }

    static bool is_moderate(const exact& energy) {
        const precision_scope rough(20);
        return from_exact<mpfr>(energy) < largest_energy;
    }

    // The part of the time that is a multiple of T: 1 for T/4, 0 for 5, in between or outside for T/4+5.
    mpfr share_of_periods(const exact& time, const mpfr& elapsed) const {
        if (!time.has_periods() || time.only_periods()) {
            return time.measure == unit::period ? 1 : 0;
        }
        return 1 - dimensionless_time<mpfr>(motion_.of(), time.without_periods()) / elapsed;
    }

    // The solutions at a time of which a share varies with T.
    template <class T>
    static variation_pair<T> at_share(const variation<T>& v, const T& share, const T& elapsed, const T& theta,
                                      const T& omega) {
        if (share == 0 || share == 1) {
            return share == 1 ? v.at_fraction(theta, omega) : v.at(elapsed, theta, omega);
        }
        auto at = v.at(elapsed, theta, omega);
        at.phi += (v.at_fraction(theta, omega).phi - at.phi) * share;
        return at;
    }

    // sum |x dtheta/dx|, from the two solutions in the arithmetic of v.
    template <class T>
    T moved(const variation<T>& v, const T& share, const T& elapsed, const T& theta, const T& omega) const {
        using std::abs;
        const auto at = at_share(v, share, elapsed, theta, omega);
        if (typed_.by_state()) {
            return abs(T(angle<T>() * v.by_angle(at))) + abs(T(v.omega0() * v.by_speed(at)));
        }
        const auto energy = from_exact<T>(typed_.gap ? *typed_.gap : *typed_.energy);
        if (typed_.theta0) {
            return abs(T(angle<T>() * v.by_angle_at_energy(at))) + abs(T(energy * v.by_energy_from_angle(at)));
        }
        return abs(T(energy * at.phi));
    }

    // y'' = -+y about the equilibria, from dtheta0 alone: the energy or omega0 is 0.
    mpfr moved_at_rest(const mpfr& elapsed) const {
        if (!typed_.theta0) {
            return 0;
        }
        const bool stable = motion_.of().regime() == regime::stable_equilibrium;
        return abs(mpfr(angle<mpfr>() * (stable ? cos(elapsed) : cosh(elapsed))));
    }

    template <class T>
    T angle() const {
        return from_exact<T>(*typed_.theta0);
    }

    proved_motion motion_;
    typed_motion typed_;
    bool differentiable_;
    std::optional<variation<double>> in_double_;  ///< if 53 bits suffice
    std::optional<variation<mpfr>> precise_;
};

}  // namespace libration::pendulum
