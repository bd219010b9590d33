// The derivatives of theta at a fixed time by the energy and the initial state: solutions of the linearised pendulum.
//
// y'' = -cos(theta(t)) y has the solution omega, a shift of time. With D = E(2-E) and J = integral of omega^2 from the
// start,
//   phi = (sin theta - omega J/4)/D
// is another, with omega phi' + sin(theta) phi = 1: J' = omega^2 implies D phi' = cos(theta) omega + sin(theta)
// J/4 - omega^3/4, so D (omega phi' + sin(theta) phi) = omega^2 cos theta - omega^4/4 + sin^2 theta = 1 - (E-1)^2 = D
// with omega^2/2 = E - 1 + cos theta. So phi is the derivative in the direction of increasing energy, and
//   dtheta/domega0 = omega0 phi - phi0 omega,     dtheta/dtheta0 = phi0' omega + sin(theta0) phi   (at fixed omega0),
//   dtheta/dE = phi - (phi0/omega0) omega,        dtheta/dtheta0 = omega/omega0                (at fixed E, theta0),
// as y and y' at the initial point show; from a canonical one, at rest or on top, dtheta/dE = phi. J follows from the
// zeta function:
//   libration  J = 4 (Z - Z_0 + mean(k^2 cn^2) t),   (sin am, cos am) = (sin(theta/2)/k, omega/(2k)), theta less turns;
//   rotation   J = 4 r (Z - Z_0 + mean(dn^2) r t),   am = theta/2 in the direction of motion, r = sqrt(E/2).
// The mean of omega^2/4 determines J T/4 of a period, by which phi decreases by omega (J_T/4)/D = omega dT/dE.
// On the separatrix, s after the bottom, phi = (sinh s + s/cosh s)/4 with the sign of the direction.
#pragma once

#include <optional>
#include <utility>

#include "libration/elliptic/jacobi_zeta.hpp"
#include "libration/pendulum/energy.hpp"
#include "libration/pendulum/phase.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The two solutions at one instant.
template <class T>
struct variation_pair {
    T omega;
    T phi;
};

/// The solutions of one motion that is not at rest, everything dimensionless. Cost: a chain of moduli in the
/// constructor, two square roots and divisions per level for a time. Absolute errors of phi: a few epsilon of t^2/D and
/// of the energy; so add as many bits as motion::condition_bits() and twice the bits of t before its point.
template <rounding_scalar T>
class variation {
public:
    /// Throws error at rest.
    explicit variation(const motion& m) : motion_(m) {
        if (m.regime() == regime::unstable_equilibrium || m.regime() == regime::stable_equilibrium) {
            throw error(error_kind::argument, "motion", "", "is at rest: it has no second solution of this form");
        }
        place_start();
        if (m.regime() == regime::separatrix) {
            phi0_ = on_separatrix(since_bottom_).phi;
            return;
        }
        level_.emplace(energy_level_of<T>(m));
        zeta_.emplace(elliptic::landen_chain<T>(level_->modulus));
        start_zeta_ = zeta_at(half_sine_, half_cosine_, omega0_);
        phi0_ = half_sine_ * half_cosine_ * 2 / critical_product();
    }

    /// At t, where the motion has this theta (unwrapped) and omega.
    variation_pair<T> at(const T& time, const T& theta, const T& omega) const {
        using std::cos;
        using std::sin;
        if (!level_) {
            return on_separatrix(T(since_bottom_ + time));
        }
        const T half = (theta - whole_turns<T>(motion_.turns())) / 2;
        const T sine = sin(half);
        const T cosine = cos(half);
        const T change = zeta_at(sine, cosine, omega) - start_zeta_;
        const T rate = level_->time_scale;
        const T action = rotates() ? T((change + zeta_->mean_of_dn_squared() * (rate * time)) * rate)
                                   : T(change + zeta_->mean_of_cn_squared() * time);
        return {omega, (sine * cosine * 2 - omega * action) / critical_product()};
    }

    /// at() for derivatives at a fixed fraction of T instead of a fixed time: dT/dE = T mean/D, with the mean
    /// above, so that phi + omega t dT/dE / T is the formula without it.
    variation_pair<T> at_fraction(const T& theta, const T& omega) const { return at(T(0), theta, omega); }

    /// The derivatives of theta there.
    T by_speed(const variation_pair<T>& at) const { return omega0_ * at.phi - phi0_ * at.omega; }
    T by_angle(const variation_pair<T>& at) const {
        return start_slope() * at.omega + half_sine_ * half_cosine_ * 2 * at.phi;
    }
    T by_energy_from_angle(const variation_pair<T>& at) const { return at.phi - phi0_ / omega0_ * at.omega; }
    T by_angle_at_energy(const variation_pair<T>& at) const { return at.omega / omega0_; }

    const T& omega0() const { return omega0_; }

private:
    bool rotates() const { return motion_.regime() == regime::rotation; }
    T critical_product() const { return level_->pair.energy * level_->pair.gap; }

    // Half of theta0 less its turns, and omega0.
    void place_start() {
        using std::cos;
        using std::sin;
        using std::sqrt;
        if (!motion_.theta0()) {  // at rest on the right
            const auto [energy, gap] = energies<T>(motion_);
            half_sine_ = sqrt(energy / 2);
            half_cosine_ = sqrt(gap / 2);
            return;
        }
        const T half = (from_exact<T>(*motion_.theta0()) - whole_turns<T>(motion_.turns())) / 2;
        half_sine_ = sin(half);
        half_cosine_ = cos(half);
        const T squared = motion_.exact_omega0_squared()
                              ? from_exact<T>(*motion_.exact_omega0_squared())
                              : T(from_rational<T>(rational(*motion_.energy() * 2)) - half_sine_ * half_sine_ * 4);
        omega0_ = sqrt(squared) * motion_.omega0_sign();
        if (motion_.regime() == regime::separatrix) {
            since_bottom_ = arsinh(T(half_sine_ / half_cosine_)) * motion_.direction();
        }
    }

    // Z, counted in the direction of motion.
    T zeta_at(const T& half_sine, const T& half_cosine, const T& omega) const {
        if (rotates()) {
            return (*zeta_)(T(half_sine * motion_.direction()), half_cosine);
        }
        return (*zeta_)(T(half_sine / level_->modulus.k), T(omega / (level_->modulus.k * 2)));
    }

    variation_pair<T> on_separatrix(const T& s) const {
        using std::cosh;
        using std::sinh;
        const T growing = cosh(s);
        return {T(2 / growing) * motion_.direction(), (sinh(s) + s / growing) / 4 * motion_.direction()};
    }

    // phi0'.
    T start_slope() const {
        using std::cosh;
        using std::tanh;
        if (level_) {
            const T cosine = half_cosine_ * half_cosine_ - half_sine_ * half_sine_;
            return omega0_ * (cosine - omega0_ * omega0_ / 4) / critical_product();
        }
        const T growing = cosh(since_bottom_);
        return (growing + (1 - since_bottom_ * tanh(since_bottom_)) / growing) / 4 * motion_.direction();
    }

    motion motion_;
    std::optional<energy_level<T>> level_;
    std::optional<elliptic::jacobi_zeta<T>> zeta_;
    T half_sine_ = T(0);
    T half_cosine_ = T(0);
    T omega0_ = T(0);
    T since_bottom_ = T(0);
    T start_zeta_ = T(0);
    T phi0_ = T(0);
};

}  // namespace libration::pendulum
