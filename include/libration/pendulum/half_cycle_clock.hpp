// From a floating-point time of any size to the nearest passage through the bottom.
#pragma once

#include "libration/pendulum/passage.hpp"
#include "libration/pendulum/sampling_constants.hpp"

#ifdef __FAST_MATH__
#error "-ffast-math takes the rounding errors apart that swing_clock keeps"
#endif

namespace libration::pendulum {

/// x as a number of T and its rounding error, rounded.
template <fixed_scalar T>
split_number<T> split(const mpfr& x) {
    const T high = narrow<T>(x);
    return {high, narrow<T>(x - widen(high))};
}

/// Passages come every 2 T*: a time t, s after the start's passage, belongs to passage j = the integer nearest to
/// (t + s)/(2 T*), and is y = t + s - 2 T* j after it, |y| <= T* up to rounding.
///
/// The reduction is Cody and Waite's [CodyWaite1980]: 2 T* in three parts, the first two with as many bits fewer
/// than T as j may have, so that t + s - j first - j second is exact up to the rounding of t + s, which is kept;
/// the third extends 2 T* to about twice the digits. So y is correct to 2^(32 - 2 digits) T* and half an epsilon of
/// itself times an epsilon, for |j| <= 2^31 and t taken as exact. Requires rounding to nearest, and neither -ffast-math
/// nor doubles in wider registers.
template <fixed_scalar T>
class half_cycle_clock {
public:
    static constexpr int passage_bits = 32;

    /// The position of a time: passage j, and x = |y| in the unit of the panels with its error; side is the sign of y.
    struct place {
        T passage;
        T x;
        T rest;
        T side;
    };

    /// interval is 2 T*, 0 for infinite; all in a precision_scope of at least 2 digits + 64 bits.
    half_cycle_clock(const mpfr& interval, const mpfr& start, const T& unit)
        : of_{.per_unit = 1 / unit,
              .start = split<T>(start / widen(unit)),
              .largest = power_of_two(passage_bits - 1),
              .rounder = power_of_two(digits<T>() - 2) * 3} {
        if (interval == 0) {
            return;
        }
        mpfr rest = interval / widen(unit);
        of_.per_passage = narrow<T>(1 / rest);
        for (T* part : {&of_.first, &of_.second}) {
            mpfr leading = rest;
            mpfr_prec_round(handle(leading), digits<T>() - passage_bits, MPFR_RNDN);
            *part = narrow<T>(leading);
            rest -= widen(*part);
        }
        of_.third = narrow<T>(rest);
    }

    const clock_constants<T>& constants() const { return of_; }

    /// Whether locate() may be called; false for NaN, too.
    [[gnu::always_inline]] bool reaches(const T& time) const {
        const T passages = (time * of_.per_unit + of_.start.high) * of_.per_passage;
        return (passages < 0 ? T(-passages) : passages) <= of_.largest;
    }

    [[gnu::always_inline]] place locate(const T& time) const {
        // t + s = since + lost without rounding; then since - 2 T* j; then the small part.
        const T t = time * of_.per_unit;
        const T since = t + of_.start.high;
        const T part = since - t;
        const T lost = (t - (since - part)) + (of_.start.high - part);
        const T j = whole(since * of_.per_passage);
        const T reduced = since - j * of_.first - j * of_.second;
        const T small = lost + (of_.start.low - j * of_.third);
        const T high = reduced + small;
        const T low = small - (high - reduced);
        const T side = high < 0 ? T(-1) : T(1);
        return {j, high * side, low * side, side};
    }

    /// The integer next to x, |x| < 2^(digits - 2): by adding a number whose unit in the last place is 1.
    [[gnu::always_inline]] T whole(const T& x) const { return (x + of_.rounder) - of_.rounder; }

private:
    static T power_of_two(int exponent) {
        using std::ldexp;
        return ldexp(T(1), exponent);
    }

    clock_constants<T> of_;
};

}  // namespace libration::pendulum
