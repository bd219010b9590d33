// theta and omega at many times: the part that depends on the motion alone is computed once, and then a time costs a
// reduction modulo the period, a look-up and some products, a few nanoseconds in double.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "libration/pendulum/sampling_tables.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// One motion, from exact initial conditions, at floating-point times in any order, in the motion's units (seconds and
/// rad/s if it has a length and a gravity). A time is taken as exact, and T is known to twice the digits: 10^9 periods
/// away the phase is as accurate as in the first one. theta is unwrapped.
///
/// Errors at every energy, next to E = 2, at E = 2 and at rest, in units epsilon 2^floor(log2 max(1, |x|)):
///   theta   at most 4, x = theta
///   omega   at most 4, x = the largest |omega| of the motion; no relative digits where omega is near 0
/// (derived in sampling_tables.hpp; the tests compare with proved values).
///
/// Cost in double: 15 to 50 microseconds once; then about 2 ns per time with AVX-512, 3.5 with AVX2, 8 with SSE, 25 ns
/// for a single time (`./run bench trajectory` measures it). In quad: some milliseconds once, 2 microseconds per time.
/// Immutable after construction: any number of threads may use one sampler. The last digit depends on the SIMD
/// instructions available (sample_vectors.hpp).
template <fixed_scalar T>
class sampler {
public:
    /// Throws error of the kind range if E or 2-E is 0 or infinite in a finer scalar than T (10^-4931 in double),
    /// and if T cannot represent the square of the time to the top (E above 10^307).
    explicit sampler(const motion& m) : sampler(m, precision_scope(working_precision())) {}

    const motion& of() const { return motion_; }

    /// At one time. Throws error if it is not finite, error of the kind range if theta is not.
    series::jet<T> operator()(const T& time) const {
        if (tables_.clock.reaches(time)) {
            return sampled_at(tables_, time);
        }
        series::jet<T> state{};
        sample_late({&time, 1}, &state.value, &state.slope);
        return state;
    }

    /// Whether all times are within the range of the clock, so that nothing is reduced in mpfr, which allocates.
    bool reaches(std::span<const T> times) const {
        return std::all_of(times.begin(), times.end(), [&](const T& time) { return tables_.clock.reaches(time); });
    }

    /// theta and omega at all times; any of the three may be the same memory. Throws error if their
    /// sizes differ, error if a time is not finite and error of the kind range if theta is not: the
    /// contents of the arrays are then unspecified.
    void operator()(std::span<const T> times, std::span<T> theta, std::span<T> omega) const {
        if (theta.size() != times.size() || omega.size() != times.size()) {
            throw error(error_kind::argument, "number of times", std::to_string(times.size()),
                        "is not that of the " + std::to_string(theta.size()) + " angles and the " +
                            std::to_string(omega.size()) + " velocities");
        }
        if constexpr (std::same_as<T, double>) {
            sample_in_vectors(times, theta, omega);
        } else {
            for (std::size_t i = 0; i < times.size(); ++i) {
                const series::jet<T> state = (*this)(times[i]);
                theta[i] = state.value;
                omega[i] = state.slope;
            }
        }
    }

private:
    sampler(const motion& m, const precision_scope& /*scope*/) : motion_(m), tables_(m) {}

    void sample_in_vectors(std::span<const T> times, std::span<T> theta, std::span<T> omega) const {
        const std::size_t whole = times.size() - times.size() % vector_block;
        sample_blocks(times.first(whole), theta.data(), omega.data());
        if (const std::size_t rest = times.size() - whole; rest > 0) {
            std::array<T, vector_block> t{};
            std::array<T, vector_block> angle;
            std::array<T, vector_block> speed;
            std::copy_n(times.data() + whole, rest, t.data());
            sample_blocks(t, angle.data(), speed.data());
            std::copy_n(angle.data(), rest, theta.data() + whole);
            std::copy_n(speed.data(), rest, omega.data() + whole);
        }
    }

    // Whole blocks; one with a time outside the range of the clock is processed separately.
    void sample_blocks(std::span<const T> times, T* theta, T* omega) const {
        for (std::size_t i = 0;; i += vector_block) {
            i += sample_vectors(tables_.vectors(), times.data() + i, times.size() - i, theta + i, omega + i);
            if (i >= times.size()) {
                return;
            }
            sample_late(times.subspan(i, vector_block), theta + i, omega + i);
        }
    }

    // Times outside the range of the clock, reduced in mpfr.
    void sample_late(std::span<const T> times, T* theta, T* omega) const {
        const precision_scope scope(working_precision());
        const T& end = tables_.panels.end();
        for (const T& time : times) {
            require_finite(time, error_kind::argument, "time", time);
            rational exact_time;
            mpfr_get_q(exact_time.backend().data(), handle(widen(time)));
            const after_passage at = nearest_passage<finer_t<T>>(motion_, exactly(exact_time));
            const half_cycle_turns<T> turns(motion_, at.passage);
            const mpfr x = abs(at.time) / widen(tables_.panels.unit());
            const split_number<T> inside = split<T>(x < widen(end) ? x : widen(end));
            const panel_place place = place_of(static_cast<double>(inside.high));
            const series::jet<T> swing = tables_.panels[place.index].at(T((inside.high - place.centre) + inside.low));
            const T sign = turns.sign(T(0), tables_.clock);
            *theta = turns.theta(T(0), T(at.time < 0 ? T(-swing.value * sign) : T(swing.value * sign)));
            require_finite(*theta++, error_kind::range, "theta at time", time);
            *omega++ = swing.slope * sign / tables_.panels.unit();
        }
    }

    static void require_finite(const T& x, error_kind kind, const char* what, const T& time) {
        if (!(x - x == 0)) {
            throw error(kind, what, std::to_string(static_cast<double>(time)), "is not finite");
        }
    }

    static long working_precision() { return decimal_digits(2 * digits<T>() + 64); }

    motion motion_;
    sampling_tables<T> tables_;
};

}  // namespace libration::pendulum
