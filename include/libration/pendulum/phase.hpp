// The phase of a motion in its cycle: exact times of any size are reduced to an integer number of T* and a small rest.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/pendulum/dimensionless_time.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/inverse_hyperbolic.hpp"

namespace libration::pendulum {

/// Time since the motion passed the bottom with theta = 2 pi turns rising (in its direction): quarter * T* + offset,
/// |offset| <= T*/2. On the separatrix and in equilibrium the quarter is 0 and the offset is the whole time.
template <class T>
struct phase {
    integer quarter;
    T offset;
    int side = 0;  ///< sign of the offset, 0 only if the motion is exactly at the quarter
};

/// 2 pi turns.
template <scalar T>
T whole_turns(const integer& turns) {
    return from_rational<T>(rational(turns * 2)) * pi<T>();
}

/// sin and cos of the amplitude of an initial state: of theta0/2 less the whole turns, and for libration, both times k,
/// sin(theta0/2) and |omega0|/2, from omega0^2 if it is an exact number, else sqrt(E/2 - sin^2(theta0/2)).
template <scalar T>
struct start_amplitude {
    T sine;
    T cosine;
};

/// Not for equilibria. At the current working precision, of which condition_bits() of the motion may cancel.
template <scalar T>
start_amplitude<T> amplitude_at_start(const motion& m) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T half = (from_exact<T>(*m.theta0()) - whole_turns<T>(m.turns())) / 2;
    T sine = sin(half);
    if (m.regime() != regime::libration) {
        return {std::move(sine), cos(half)};
    }
    T speed = m.exact_omega0_squared() ? T(sqrt(from_exact<T>(*m.exact_omega0_squared())) / 2)
                                       : T(sqrt(from_rational<T>(rational(*m.energy() / 2)) - sine * sine));
    return {std::move(sine), std::move(speed)};
}

/// The clock of one motion. Its T* is exact, or the approximation of a rule, as the paper's modulo uses it. The time
/// from the nearest quarter to a start between the quarters is exact in either case, and so is the T of a time 3T/4.
template <scalar T>
class phase_map {
    using W = wide_t<T>;

public:
    explicit phase_map(motion m, period_rule by = {})
        : motion_(std::move(m)), by_(by), start_(start_at(bits_for(default_margin + spare_margin))) {}

    /// The phase at an exact time (multiples of T allowed if the motion has one): T* is computed to as many more
    /// digits as the time has before its point, so the rest is correct to an ulp of T* in T, and of itself near a
    /// quarter. Throws error for a multiple of an infinite period.
    phase<T> at(const exact& time) const {
        const phase<W> wide = wide_at(time);
        return {wide.quarter, narrow<T>(wide.offset), wide.side};
    }

    /// The phase of a symmetric point: quarter * T* after the bottom.
    static phase<T> at_quarter(const integer& quarter) { return {quarter, T(0), 0}; }

private:
    static constexpr long default_margin = 96;
    static constexpr long spare_margin = 16;  // times below 2^8 use the existing start

    // The start of the motion, an exact quarter or an offset, and T*, computed with this many bits.
    struct origin {
        long bits;
        int quarter = 0;
        W offset;
        W effective_period;
    };

    // The last start of more bits: times of one size need the same one. Several threads may request it at once; none
    // waits, and the result depends on the bits alone.
    class later_start {
    public:
        later_start() = default;
        later_start(const later_start& other) : last_(other.last_.load()) {}
        later_start& operator=(const later_start& other) {
            last_.store(other.last_.load());
            return *this;
        }
        ~later_start() = default;

        template <class Make>
        std::shared_ptr<const origin> of(long bits, const Make& make) const {
            std::shared_ptr<const origin> last = last_.load();
            if (last == nullptr || last->bits != bits) {
                last = std::make_shared<const origin>(make(bits));
                last_.store(last);
            }
            return last;
        }

    private:
        mutable std::atomic<std::shared_ptr<const origin>> last_;
    };

    // The current precision at the call, plus the cancellation of the motion, plus the margin.
    long bits_for(long margin) const { return digits<T>() + motion_.condition_bits() + margin; }

    phase<W> wide_at(const exact& time) const {
        if (time.has_periods() && at_critical_energy(motion_.regime())) {
            throw error(error_kind::argument, error_subject::time, time.text, "is a multiple of an infinite period");
        }
        if (time.has_periods() && by_.method == period_method::agm) {
            const exact rest = time.without_periods();
            return advance(rest, rational(time.periods() * quarters_per_period(motion_.regime())), bits_at(rest));
        }
        return advance(time, 0, bits_at(time));
    }

    // The bits for a time with digits before its point.
    long bits_at(const exact& time) const {
        long before_point = 0;
        if (!time.is_zero()) {
            const precision_scope rough(20);
            before_point = std::max(0L, binary_exponent(dimensionless_time<W>(motion_, time)));
        }
        return bits_for(default_margin + 2 * before_point);
    }

    // Start + elapsed + quarters * T*, reduced.
    phase<W> advance(const exact& elapsed, const rational& quarters, long bits) const {
        const auto later = bits > start_.bits ? later_.of(bits, [this](long with) { return start_at(with); }) : nullptr;
        const origin& start = later == nullptr ? start_ : *later;
        const precision_scope scope(decimal_digits(bits));
        integer quarter = start.quarter;
        W offset = start.offset + dimensionless_time<W>(motion_, elapsed);
        if (!at_critical_energy(motion_.regime())) {
            const integer whole = nearest_integer(quarters);
            offset += from_rational<W>(rational(quarters - rational(whole))) * start.effective_period;
            const integer more = nearest_integer(W(offset / start.effective_period));
            offset -= from_rational<W>(rational(more)) * start.effective_period;
            quarter += whole + more;
        }
        const int side = decided_sign(offset);
        return {quarter, std::move(offset), side};
    }

    origin start_at(long bits) const {
        const precision_scope scope(decimal_digits(bits));
        origin start{bits, motion_.start_quarter().value_or(0), W(0), W(0)};
        if (!at_critical_energy(motion_.regime())) {
            start.effective_period = effective_period_by(by_, energy_level_of<W>(motion_));
        }
        if (!motion_.start_quarter() && motion_.regime() != regime::unstable_equilibrium) {
            place_start(start);
        }
        return start;
    }

    // The offset of an initial point between the symmetric points.
    void place_start(origin& start) const {
        const auto [sine, cosine] = amplitude_at_start<W>(motion_);
        if (motion_.regime() == regime::separatrix) {
            start.offset = arsinh(W(sine / cosine)) * motion_.direction();
            return;
        }
        const energy_level<W> o = energy_level_of<W>(motion_);
        const elliptic::landen_chain<W> chain(o.modulus);
        if (motion_.regime() == regime::rotation) {
            start.offset = incomplete_integral(sine, cosine, chain) * motion_.direction() / o.time_scale;
            return;
        }
        // If omega0 < 0 the reflection 2K - F.
        const bool falling = motion_.omega0_sign() < 0;
        const W from_bottom = incomplete_integral(sine, cosine, chain);
        start.quarter = falling ? 2 : 0;
        start.offset = falling ? W(-from_bottom) : from_bottom;
    }

    motion motion_;
    period_rule by_;
    origin start_;
    later_start later_;
};

}  // namespace libration::pendulum
