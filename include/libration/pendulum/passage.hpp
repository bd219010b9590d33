// Passages through the bottom: the nearest one to a time, and to the start.
#pragma once

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/phase.hpp"

namespace libration::pendulum {

/// A passage through the bottom, counted from the one with theta = 2 pi turns, rising, and the time since then.
struct after_passage {
    integer passage;
    mpfr time;
};

/// Whether the motion reaches the top and returns, T* < infinity; at E = 0 it only does so in the limit.
inline bool has_passages(const motion& m) { return m.regime() == regime::libration || m.regime() == regime::rotation; }

/// 2 T* in the units of the motion, 0 if no passage recurs, at the current working precision.
inline mpfr passage_interval(const motion& m) {
    return has_passages(m) ? mpfr(effective_period(energy_level_of<mpfr>(m)) * time_unit<mpfr>(m) * 2) : mpfr(0);
}

/// The passage nearest to an exact time. Cost and exceptions: those of a phase map.
template <rounding_scalar T>
after_passage nearest_passage(const motion& m, const exact& time) {
    const phase<T> p = phase_map<T>(m).at(time);
    const mpfr offset = widen(p.offset) * time_unit<mpfr>(m);
    if (elliptic::quarter_of_four(p.quarter) % 2 == 0) {
        return {p.quarter / 2, offset};
    }
    const int sign = p.side < 0 ? -1 : 1;
    return {integer((p.quarter + sign) / 2), offset - passage_interval(m) / 2 * sign};
}

/// The passage at an initial point between the symmetric points, as located by the phase map: the amplitude, which may
/// cancel, in mpfr, and the integral of this well-conditioned pair in T, in a tenth of the time.
template <rounding_scalar T>
after_passage passage_before_start(const motion& m) {
    const precision_scope scope(decimal_digits(digits<mpfr>() + m.condition_bits()));
    const auto [sine, cosine] = amplitude_at_start<mpfr>(m);
    if (m.regime() == regime::separatrix) {
        return {0, arsinh(mpfr(sine / cosine)) * m.direction() * time_unit<mpfr>(m)};
    }
    const auto o = energy_level_of<T>(m);
    const elliptic::landen_chain<T> chain(o.modulus);
    const mpfr along = widen(T(incomplete_integral(narrow<T>(sine), narrow<T>(cosine), chain) / o.time_scale));
    const bool falls = m.regime() == regime::libration && m.omega0_sign() < 0;
    const int sign = m.regime() == regime::rotation ? m.direction() : falls ? -1 : 1;
    return {falls ? 1 : 0, along * time_unit<mpfr>(m) * sign};
}

/// The passage nearest to the start of a motion with this interval between passages, correct to some epsilon of T.
template <rounding_scalar T>
after_passage passage_at_start(const motion& m, const mpfr& interval) {
    if (m.regime() == regime::stable_equilibrium || m.regime() == regime::unstable_equilibrium) {
        return {0, mpfr(0)};
    }
    if (!m.start_quarter()) {
        return passage_before_start<T>(m);
    }
    const int quarter = *m.start_quarter();
    return quarter % 2 == 0 ? after_passage{quarter / 2, mpfr(0)}
                            : after_passage{(quarter + 1) / 2, mpfr(-interval / 2)};
}

}  // namespace libration::pendulum
