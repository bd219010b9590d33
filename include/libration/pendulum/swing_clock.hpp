// From a time in floating point, however late, to the nearest passage through the bottom and the whole turns before it.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/pendulum/swing_panels.hpp"

#ifdef __FAST_MATH__
#error "-ffast-math takes the rounding errors apart that swing_clock keeps"
#endif

namespace libration {

/// A passage through the bottom, counted from the one with theta = 2 pi turns, rising, and the time since then.
struct after_passage {
    integer passage;
    mpfr time;
};

/// Whether the motion comes to the top and back, T* < infinity; at E = 0 it only does so in the limit.
inline bool has_passages(const motion& m) { return m.regime() == regime::libration || m.regime() == regime::rotation; }

/// 2 T* in the units of the motion, 0 where nothing passes twice, at the working precision in force.
inline mpfr passage_interval(const motion& m) {
    return has_passages(m) ? mpfr(effective_period(orbit_of<mpfr>(m)) * time_unit<mpfr>(m) * 2) : mpfr(0);
}

/// The passage next to an exact time. Cost: a timeline. Throws as that.
template <rounding_scalar T>
after_passage nearest_passage(const motion& m, const exact& time) {
    const phase<T> p = timeline<T>(m).at(time);
    const mpfr offset = widen(p.offset) * time_unit<mpfr>(m);
    if (quarter_of_four(p.quarter) % 2 == 0) {
        return {p.quarter / 2, offset};
    }
    const int way = p.side < 0 ? -1 : 1;
    return {integer((p.quarter + way) / 2), offset - passage_interval(m) / 2 * way};
}

/// The passage at a start between the symmetric points, as timeline places it: sine and cosine of the amplitude, which may
/// cancel, in mpfr, and the integral of this well conditioned pair in T, in a tenth of the time.
template <rounding_scalar T>
after_passage passage_before_start(const motion& m) {
    const precision_scope scope(decimal_digits(digits<mpfr>() + m.condition_bits()));
    const mpfr half = (from_exact<mpfr>(*m.theta0()) - whole_turns<mpfr>(m.turns())) / 2;
    const mpfr sine = sin(half);
    mpfr cosine = cos(half);
    if (m.regime() == regime::separatrix) {
        return {0, arsinh(mpfr(sine / cosine)) * m.direction() * time_unit<mpfr>(m)};
    }
    if (m.regime() == regime::libration) {
        const mpfr kinetic = m.omega0_squared() ? from_rational<mpfr>(rational(*m.omega0_squared() / 4))
                                                : from_rational<mpfr>(rational(*m.energy() / 2)) - sine * sine;
        cosine = sqrt(kinetic);
    }
    const auto o = orbit_of<T>(m);
    const landen_chain<T> chain(o.shape);
    const mpfr along = widen(T(incomplete_integral(narrow<T>(sine), narrow<T>(cosine), chain) / o.rate));
    const bool falls = m.regime() == regime::libration && m.omega0_sign() < 0;
    const int way = m.regime() == regime::rotation ? m.direction() : falls ? -1 : 1;
    return {falls ? 1 : 0, along * time_unit<mpfr>(m) * way};
}

/// The passage next to the start of a motion whose passages come in this interval, right to some epsilon of T.
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

/// x as a number of T and what it lacks.
template <fixed_scalar T>
struct split_number {
    explicit split_number(const mpfr& x) : high(narrow<T>(x)), low(narrow<T>(x - widen(high))) {}

    T high;
    T low;
};

/// Passages come every 2 T*: a time t, s after the start's passage, belongs to passage j = the integer nearest to
/// (t + s)/(2 T*), and lies y = t + s - 2 T* j after it, |y| <= T* up to rounding.
///
/// The reduction is Cody and Waite's [CodyWaite1980]: 2 T* in three parts, the first two with as many bits fewer than T as
/// j may have, so that t + s - j first - j second is exact but for the rounding of t + s, which is kept; the third brings
/// 2 T* to about twice the digits. So y is right to 2^(32 - 2 digits) T* and half an epsilon of itself times an epsilon, for
/// |j| <= 2^31 and t taken as exact. Needs rounding to nearest, and neither -ffast-math nor doubles in wider registers.
template <fixed_scalar T>
class swing_clock {
public:
    static constexpr int passage_bits = 32;

    /// Where a time is: passage j, and x = |y| in the unit of the panels with what it lacks; side is the sign of y.
    struct place {
        T passage;
        T x;
        T rest;
        T side;
    };

    /// interval is 2 T*, 0 for infinite; all in a precision_scope of at least 2 digits + 64 bits.
    swing_clock(const mpfr& interval, const mpfr& start, const T& unit)
        : per_unit_(1 / unit),
          start_(start / widen(unit)),
          largest_(power_of_two(passage_bits - 1)),
          rounder_(power_of_two(digits<T>() - 2) * 3) {
        if (interval == 0) {
            return;
        }
        mpfr rest = interval / widen(unit);
        per_passage_ = narrow<T>(1 / rest);
        for (T* part : {&first_, &second_}) {
            mpfr leading = rest;
            mpfr_prec_round(handle(leading), digits<T>() - passage_bits, MPFR_RNDN);
            *part = narrow<T>(leading);
            rest -= widen(*part);
        }
        third_ = narrow<T>(rest);
    }

    /// Whether locate() may be asked; false for what is not a number, too.
    [[gnu::always_inline]] bool reaches(const T& time) const {
        const T passages = (time * per_unit_ + start_.high) * per_passage_;
        return (passages < 0 ? T(-passages) : passages) <= largest_;
    }

    [[gnu::always_inline]] place locate(const T& time) const {
        // t + s = since + lost without rounding; then since - 2 T* j; then what is small.
        const T t = time * per_unit_;
        const T since = t + start_.high;
        const T part = since - t;
        const T lost = (t - (since - part)) + (start_.high - part);
        const T j = whole(since * per_passage_);
        const T reduced = since - j * first_ - j * second_;
        const T small = lost + (start_.low - j * third_);
        const T high = reduced + small;
        const T low = small - (high - reduced);
        const T side = high < 0 ? T(-1) : T(1);
        return {j, high * side, low * side, side};
    }

    /// The integer next to x, |x| < 2^(digits - 2): by adding a number whose unit in the last place is 1.
    [[gnu::always_inline]] T whole(const T& x) const { return (x + rounder_) - rounder_; }

private:
    static T power_of_two(int exponent) {
        using std::ldexp;
        return ldexp(T(1), exponent);
    }

    T per_unit_;
    split_number<T> start_;
    T largest_;
    T rounder_;
    T per_passage_ = T(0);
    T first_ = T(0);
    T second_ = T(0);
    T third_ = T(0);
};

/// theta of the motion from that of the swing, g(y), after passage j: (-1)^j g in the libration, 2 pi (turns + d j) + d g
/// in the rotation, d its direction.
template <fixed_scalar T>
class swing_turns {
public:
    /// The start's passage is counted as j = 0. In a precision_scope of at least 2 digits + 64 bits.
    swing_turns(const motion& m, const integer& passage)
        : turn_(pi<mpfr>() * 2), base_(base_of(m, passage)), sign_(T(sign_of_start(m, passage))) {
        const bool rotates = m.regime() == regime::rotation;
        winding_ = rotates ? T(m.direction()) : T(0);
        alternation_ = m.regime() == regime::libration ? T(2) : T(0);
        if (counts(m, passage)) {
            turns_ = from_rational<T>(rational(turns_of(m, passage)));
        }
    }

    /// The sign of omega after passage j, +-1; clock.whole() rounds j/2.
    [[gnu::always_inline]] T sign(const T& passage, const swing_clock<T>& clock) const {
        const T odd = passage - clock.whole(passage / 2) * 2;
        return sign_ - sign_ * alternation_ * (odd < 0 ? T(-odd) : odd);
    }

    /// theta, where part = g(y) times the sign.
    [[gnu::always_inline]] T theta(const T& passage, const T& part) const {
        const T turns = turns_ + winding_ * passage;
        return base_.high + (turns * turn_.high + (turns * turn_.low + (base_.low + part)));
    }

    /// The turns of theta at a passage, from the start's one where it is counted from there.
    static integer turns_of(const motion& m, const integer& passage) {
        return m.regime() == regime::rotation ? integer(m.turns() + passage * m.direction()) : m.turns();
    }

private:
    // Turns that T counts are kept as a number, so that they may cancel; others as an angle.
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

    split_number<T> turn_;
    split_number<T> base_;
    T sign_;
    T turns_ = T(0);
    T winding_ = T(0);
    T alternation_ = T(0);
};

}  // namespace libration
