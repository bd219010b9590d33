// The exact solution through Jacobi's functions, unwrapped, at every energy: the reference for the errors of series.
#pragma once

#include <optional>
#include <utility>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/phase.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// theta and omega at one instant, with sin(theta/2) and cos(theta/2) to full relative precision near their zeros
/// (theta less 4 pi times whole turns; only their products and squares are meaningful by themselves).
template <scalar T>
struct pendulum_state {
    T theta;
    T omega;
    T half_sine;
    T half_cosine;

    /// sin theta and cos theta, relative near the zeros of sin theta; no cancellation other than that of the halves.
    T sine() const { return half_sine * half_cosine * 2; }
    T cosine() const { return (half_cosine - half_sine) * (half_cosine + half_sine); }
};

/// With s = time since the bottom, u = s * rate and sn, cn, dn of modulus k at u [paper (subcritical), (supercritical),
/// (critical), without their restrictions]:
///   libration   theta = 2 pi turns + 2 atan2(k sn, dn),         omega = 2 k cn
///   rotation    theta = 2 pi turns + direction 2 am(u),         omega = direction 2 rate dn
///   separatrix  theta = 2 pi turns + direction 2 gd(s),         omega = direction 2/cosh s,   gd = 2 atan tanh(s/2)
///   equilibria  constant.
/// Between the bottom and the top everything is computed from the nearer of the two. Absolute error a few epsilon times
/// max(1, |theta|) in theta and a few epsilon relative to its maximum in omega, at times taken as exact. Everything is
/// dimensionless, omega too: divide it by time_unit() for rad/s. Use it in the precision_scope in which it was
/// constructed; a wider one throws std::logic_error.
template <closed_form_scalar T>
class exact_solution {
public:
    explicit exact_solution(const motion& m) : motion_(m), phase_map_(m) {
        if (!at_critical_energy(m.regime())) {
            level_.emplace(energy_level_of<T>(m));
            chain_.emplace(level_->modulus);
            effective_period_ = complete_integral(*chain_) / level_->time_scale;
        }
    }

    const motion& of() const { return motion_; }
    const phase_map<T>& phases() const { return phase_map_; }

    /// State at an exact time.
    pendulum_state<T> operator()(const exact& time) const { return at(phase_map_.at(time)); }

    /// State at a fraction x in [0, 1] of the arc from the top (at E = 2 there is none: throws) down to the bottom.
    pendulum_state<T> from_top(const T& x) const {
        if (!level_) {
            throw error(error_kind::argument, error_subject::energy, "2", "leaves the motion without a top");
        }
        const integer quarter = nearest_integer(widen(x));
        const T offset = (x - from_rational<T>(rational(quarter))) * effective_period_;
        return at({top_quarter(motion_) + quarter, offset, 0});
    }

    /// State at a phase.
    pendulum_state<T> at(const phase<T>& p) const {
        born_.require();
        switch (motion_.regime()) {
            case regime::rotation: return rotating(p);
            case regime::separatrix: return on_separatrix(p);
            case regime::unstable_equilibrium: return {from_exact<T>(*motion_.theta0()), T(0), T(1), T(0)};
            case regime::libration:
            case regime::stable_equilibrium: break;
        }
        return librating(p);
    }

    /// The quarter of the top from which canonical motions start: +theta_max or (turns + 1/2) 2 pi.
    static integer top_quarter(const motion& m) {
        return m.regime() == regime::rotation && m.direction() < 0 ? integer(-1) : integer(1);
    }

private:
    elliptic::jacobi_values<T> values(const phase<T>& p, int quarter) const {
        return advance_quarters(jacobi_at(T(p.offset * level_->time_scale), *chain_), quarter,
                                level_->modulus.complement);
    }

    pendulum_state<T> librating(const phase<T>& p) const {
        using std::atan2;
        const auto v = values(p, elliptic::quarter_of_four(p.quarter));
        const T half_sine = level_->modulus.k * v.sn;
        return {whole_turns<T>(motion_.turns()) + atan2(half_sine, v.dn) * 2, level_->modulus.k * v.cn * 2, half_sine,
                v.dn};
    }

    pendulum_state<T> rotating(const phase<T>& p) const {
        using std::atan2;
        const int odd = elliptic::quarter_of_four(p.quarter) % 2;
        const auto v = values(p, odd);
        const int d = motion_.direction();
        const integer half_turns = (p.quarter - odd) / 2;
        const T theta = whole_turns<T>(integer(motion_.turns() + half_turns * d)) + atan2(v.sn, v.cn) * (2 * d);
        return {theta, v.dn * level_->time_scale * (2 * d), v.sn * d, v.cn};
    }

    // sin(theta/2) = tanh s, cos(theta/2) = 1/cosh s.
    pendulum_state<T> on_separatrix(const phase<T>& p) const {
        using std::atan;
        using std::cosh;
        using std::tanh;
        const int d = motion_.direction();
        const T half_cosine = 1 / cosh(p.offset);
        const T theta = whole_turns<T>(motion_.turns()) + atan(tanh(p.offset / 2)) * (4 * d);
        return {theta, half_cosine * (2 * d), tanh(p.offset) * d, half_cosine};
    }

    born_precision<T> born_;
    motion motion_;
    phase_map<T> phase_map_;
    std::optional<energy_level<T>> level_;
    std::optional<elliptic::landen_chain<T>> chain_;
    T effective_period_ = T(0);
};

}  // namespace libration::pendulum
