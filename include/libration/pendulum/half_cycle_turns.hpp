// theta after a passage through the bottom from that of the half-cycle: signs and whole turns.
#pragma once

#include "libration/pendulum/half_cycle_clock.hpp"

namespace libration::pendulum {

/// theta of the motion from that of the half-cycle, g(y), after passage j: (-1)^j g in libration, 2 pi (turns + d j) +
/// d g in rotation, d its direction.
template <fixed_scalar T>
class half_cycle_turns {
public:
    /// The start's passage is counted as j = 0. In a precision_scope of at least 2 digits + 64 bits.
    half_cycle_turns(const motion& m, const integer& passage)
        : of_{.turn = split<T>(pi<mpfr>() * 2),
              .base = split<T>(base_of(m, passage)),
              .sign = T(sign_of_start(m, passage))} {
        const bool rotates = m.regime() == regime::rotation;
        of_.winding = rotates ? T(m.direction()) : T(0);
        of_.alternation = m.regime() == regime::libration ? T(2) : T(0);
        if (counts(m, passage)) {
            of_.turns = from_rational<T>(rational(turns_of(m, passage)));
        }
    }

    const turn_constants<T>& constants() const { return of_; }

    /// The sign of omega after passage j, +-1; clock.whole() rounds j/2.
    [[gnu::always_inline]] T sign(const T& passage, const half_cycle_clock<T>& clock) const {
        const T odd = passage - clock.whole(passage / 2) * 2;
        return of_.sign - of_.sign * of_.alternation * (odd < 0 ? T(-odd) : odd);
    }

    /// theta, if part = g(y) times the sign.
    [[gnu::always_inline]] T theta(const T& passage, const T& part) const {
        const T turns = of_.turns + of_.winding * passage;
        return of_.base.high + (turns * of_.turn.high + (turns * of_.turn.low + (of_.base.low + part)));
    }

    /// The turns of theta at a passage, from those of the start if they are counted from there.
    static integer turns_of(const motion& m, const integer& passage) {
        return m.regime() == regime::rotation ? integer(m.turns() + passage * m.direction()) : m.turns();
    }

private:
    // Turns that T can represent are kept as a number, so that they may cancel; others as an angle.
    static bool counts(const motion& m, const integer& passage) {
        return m.regime() != regime::unstable_equilibrium &&
               abs(turns_of(m, passage)) < pow(integer(2), static_cast<unsigned>(digits<T>() - 3));
    }

    static mpfr base_of(const motion& m, const integer& passage) {
        if (m.regime() == regime::unstable_equilibrium) {
            return from_exact<mpfr>(*m.theta0());
        }
        return counts(m, passage) ? mpfr(0) : whole_turns<mpfr>(turns_of(m, passage));
    }

    static int sign_of_start(const motion& m, const integer& passage) {
        if (m.regime() == regime::libration) {
            return passage % 2 == 0 ? 1 : -1;
        }
        return m.regime() == regime::stable_equilibrium ? 1 : m.direction();
    }

    turn_constants<T> of_;
};

}  // namespace libration::pendulum
