// From an approximation on [0, T*] to all times by symmetry, negative ones too, and from the canonical motion to any
// initial conditions by the shift of the origin [paper (newseries)].
#pragma once

#include <utility>

#include "libration/pendulum/resummation.hpp"

namespace libration::pendulum {

/// theta and omega of a motion, from any function of x in [0, 1] that approximates its fundamental arc (jets in x).
///
/// With x the time since the nearest top over T*, before or after it, f the fundamental arc and i whole turns:
///   libration  theta - 2 pi turns = f near the top +theta_max, -f near the top -theta_max
///   rotation   theta = 2 pi (turns + d i) + d f after a top, 2 pi - f before it (d the direction).
///
/// T* is exact, or that of a rule: then it is used throughout, for the modulo, for the mirrors at T*, 2 T* and 3 T*
/// and for the shift of the origin by whole T*, and f must be computed with the same one (arc_of with the rule). A T*
/// with an error dT* puts the motion out of step by 4 dT* (rotation 2 dT*) in every period.
template <scalar T, class F>
class periodic_extension {
public:
    /// Throws error at E = 2.
    periodic_extension(const motion& m, F on_arc, const period_rule& by = {})
        : motion_(m),
          phase_map_(m, by),
          effective_period_(effective_period_by(by, energy_level_of<T>(m))),
          f_(std::move(on_arc)) {}

    /// At an exact time.
    series::jet<T> operator()(const exact& time) const { return at(phase_map_.at(time)); }

    /// At a phase.
    series::jet<T> at(const phase<T>& p) const {
        born_.require();
        const bool top = elliptic::quarter_of_four(p.quarter) % 2 != 0;
        const T away = p.offset * p.side / effective_period_;
        series::jet<T> part = top ? f_(away) : before_bottom(away);
        part.slope /= effective_period_;
        // Before the nearest top the fundamental arc is traversed backwards. At a bottom "after" means coming down from
        // the top before.
        const bool after = top ? p.side >= 0 : p.side <= 0;
        const integer nearest_top = top ? p.quarter : integer(p.quarter + (after ? -1 : 1));
        return motion_.regime() == regime::rotation ? rotating(part, nearest_top, after)
                                                    : librating(part, nearest_top, after);
    }

private:
    // An f that accepts the time before the bottom receives that: 1 - away would lose the digits of a small one.
    series::jet<T> before_bottom(const T& away) const {
        if constexpr (requires { f_.before_bottom(away); }) {
            return f_.before_bottom(away);
        } else {
            return f_(T(1 - away));
        }
    }

    series::jet<T> librating(const series::jet<T>& part, const integer& top, bool after) const {
        const int sign = elliptic::quarter_of_four(top) == 1 ? 1 : -1;
        return {whole_turns<T>(motion_.turns()) + part.value * sign, part.slope * (after ? sign : -sign)};
    }

    // Counterclockwise the top of quarter 2 i + 1 is at theta = 2 pi i + pi.
    series::jet<T> rotating(const series::jet<T>& part, const integer& top, bool after) const {
        const int d = motion_.direction();
        const integer half_turns = (top - 1) / 2;
        const T value = after ? part.value : T(pi<T>() * 2 - part.value);
        return {whole_turns<T>(integer(motion_.turns() + half_turns * d)) + value * d, part.slope * d};
    }

    born_precision<T> born_;
    motion motion_;
    phase_map<T> phase_map_;
    T effective_period_;
    F f_;
};

}  // namespace libration::pendulum
