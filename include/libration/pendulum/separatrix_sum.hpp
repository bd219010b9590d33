// A second route to the exact solution: every motion of the pendulum is a sum of separatrix solutions in scaled time.
// It shares T*, K~' and the initial phase of the clock with the first route, but no elliptic function.
//
// With c = pi/(2 K~'), gd(z) = atan sinh z and r the time since the nearest passage through the bottom, a_i = 2 i c T*,
//     libration  theta = (-1)^j [2 gd(c r) + sum_{i>=1} (-1)^i 4 atan(sinh(c r)/cosh a_i)]
//     rotation   theta = 2 pi j + 2 gd(c r) + sum_{i>=1} 4 atan(sinh(c r)/cosh a_i)
// where j counts the passages. This is the sum over columns (-1)^j 2 gd(c (s - 2 j T*)) over all passages j, combined
// in pairs around the nearest column by gd(a + z) - gd(a - z) = 2 atan(sinh z/cosh a), which does not cancel.
#pragma once

#include <optional>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/phase.hpp"
#include "libration/series/jet.hpp"

namespace libration::pendulum {

/// theta and omega by the sum. Absolute error a few epsilon per pair of columns; at tiny energies theta is small and
/// its relative digits cancel (terms are near 0.4): use more digits there. Cost: digits log 2/(2 c T*) pairs.
template <scalar T>
class separatrix_sum {
public:
    /// With this many pairs, at least 1; by default as many as the precision needs. Throws error at E = 2 (where there
    /// is one column) and E = 0 (where they are infinitely many).
    explicit separatrix_sum(const motion& m, std::optional<long> pairs = {}) : motion_(m), phase_map_(m) {
        const energy_level<T> o = energy_level_of<T>(m);
        effective_period_ = effective_period(o);
        rate_ = pi<T>() / (singularity_height(o) * 2);
        pairs_ = pairs ? *pairs : pairs_for_precision();
    }

    long pairs() const { return pairs_; }

    /// At an exact time.
    series::jet<T> operator()(const exact& time) const { return at(phase_map_.at(time)); }

    /// At a phase. From a_i to a_{i+1} = a_i + d, d = 2 c T*, cosh grows at least by the factor cosh d; so the omitted
    /// pairs sum to at most the last one kept over cosh d - 1, for theta and for omega.
    series::jet<T> at(const phase<T>& p) const {
        born_.require();
        // The nearest passage through the bottom is an even quarter: this one, or the one on this side of the top.
        const bool near_top = elliptic::quarter_of_four(p.quarter) % 2 != 0;
        const int toward = near_top ? (p.side < 0 ? -1 : 1) : 0;
        const integer passage = (p.quarter + toward) / 2;
        const series::jet<T> part = around_bottom(p.offset - effective_period_ * toward);
        const integer turns = motion_.turns();
        if (motion_.regime() == regime::rotation) {
            const int d = motion_.direction();
            return {whole_turns<T>(integer(turns + passage * d)) + part.value * d, part.slope * d};
        }
        const int sign = passage % 2 == 0 ? 1 : -1;
        return {whole_turns<T>(turns) + part.value * sign, part.slope * sign};
    }

private:
    // A pair is exp(-2 c T*) of the one before it, and log 2 < 7/10. This number determines the cost; the truncation
    // error is enclosed whatever it is.
    long pairs_for_precision() const {
        using W = wide_t<T>;
        const W decay = widen(T(rate_ * effective_period_ * 2));
        return 3 + static_cast<long>(nearest_integer(W(W((digits<T>() + 8) * 7) / 10 / decay)));
    }

    // The sum at r and its derivative with respect to r.
    series::jet<T> around_bottom(const T& r) const {
        using std::atan;
        using std::cosh;
        using std::sinh;
        const int alternate = motion_.regime() == regime::rotation ? 1 : -1;
        const T sine = sinh(rate_ * r);
        const T cosine = cosh(rate_ * r);
        T value = atan(sine) * 2;
        T slope = 2 / cosine;
        int sign = alternate;
        T q = sine;
        T last = 2 / cosine;
        for (long i = 1; i <= pairs_; ++i) {
            const T inverse = 1 / cosh(rate_ * effective_period_ * static_cast<int>(2 * i));
            q = sine * inverse;
            value += atan(q) * (4 * sign);
            last = cosine * inverse * 4;
            slope += last / (1 + q * q) * sign;
            sign *= alternate;
        }
        const T half = sinh(rate_ * effective_period_);
        const T growth = half * half * 2;  // cosh d - 1
        return {enclose(value, T(q * 4 / growth)), enclose(T(slope * rate_), T(last * rate_ / growth))};
    }

    born_precision<T> born_;
    motion motion_;
    phase_map<T> phase_map_;
    T effective_period_ = T(0);
    T rate_ = T(0);
    long pairs_ = 0;
};

}  // namespace libration::pendulum
