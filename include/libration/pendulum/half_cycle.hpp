// The state of a motion rising from the bottom, at rounded times: the source of the tables of the sampler.
#pragma once

#include <optional>
#include <utility>

#include "libration/pendulum/exact_solution.hpp"

namespace libration::pendulum {

/// theta and omega since a passage through the bottom with theta = 0 rising, whatever the initial state, the turns and
/// the direction of the motion [paper (subcritical), (supercritical), (critical)]. An equilibrium remains at 0.
/// Dimensionless.
template <rounding_scalar T>
class half_cycle {
public:
    explicit half_cycle(const motion& m) : pair_(energies<T>(m)), regime_(m.regime()) {
        if (!at_critical_energy(regime_) && regime_ != regime::stable_equilibrium) {
            level_.emplace(energy_level_of<T>(m));
            chain_.emplace(level_->modulus);
            effective_period_ = complete_integral(*chain_) / level_->time_scale;
        }
    }

    const energy_pair<T>& pair() const { return pair_; }
    bool has_top() const { return level_.has_value(); }
    /// T*, if there is a top.
    const T& effective_period() const { return effective_period_; }
    /// K~', the height of the nearest singularities above the bottom; pi/2 on the separatrix. Not for equilibria.
    T height() const { return level_ ? singularity_height(*level_) : T(pi<T>() / 2); }
    bool constant() const { return !level_ && regime_ != regime::separatrix; }

    /// At a time in [0, 3/2 T*], from the nearer of bottom and top. Errors of a few epsilon, those of exact_solution.
    pendulum_state<T> at(const T& time) const {
        using std::atan2;
        if (constant()) {
            return {T(0), T(0), T(0), T(1)};
        }
        if (!level_) {
            return on_separatrix(time);
        }
        const bool upper = time * 2 > effective_period_;
        const T offset = upper ? T(time - effective_period_) : time;
        const auto near = jacobi_at(T(offset * level_->time_scale), *chain_);
        const auto v = advance_quarters(near, upper ? 1 : 0, level_->modulus.complement);
        if (regime_ == regime::rotation) {
            return {atan2(v.sn, v.cn) * 2, v.dn * level_->time_scale * 2, v.sn, v.cn};
        }
        const T half_sine = level_->modulus.k * v.sn;
        return {atan2(half_sine, v.dn) * 2, level_->modulus.k * v.cn * 2, half_sine, v.dn};
    }

private:
    static pendulum_state<T> on_separatrix(const T& time) {
        using std::atan;
        using std::cosh;
        using std::tanh;
        const T half_cosine = 1 / cosh(time);
        return {atan(tanh(T(time / 2))) * 4, half_cosine * 2, tanh(time), half_cosine};
    }

    energy_pair<T> pair_;
    pendulum::regime regime_;
    std::optional<energy_level<T>> level_;
    std::optional<elliptic::landen_chain<T>> chain_;
    T effective_period_ = T(0);
};

}  // namespace libration::pendulum
