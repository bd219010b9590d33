// theta, omega and the constants of one motion as proved decimals: the part that depends on the energy alone is
// computed once for every working precision and shared by all times.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/proved_motion.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::pendulum {

/// The digits that a time loses before its point when it is reduced; 0 for multiples of T, which are reduced exactly.
long digits_before_point(const motion& m, const exact& time);

/// E, 2 - E, T, T* and the radius of convergence of the series of theta.
enum class motion_constant { energy, gap, period, effective_period, radius };

/// The digits of one motion. Not for several threads at once.
class proved_states {
public:
    proved_states(motion m, long digits) : motion_(std::move(m)), digits_(digits) {}

    struct state_text {
        std::string theta;
        std::string omega;
    };

    /// theta and omega at a time, each digit proved; 0 where they vanish by symmetry. Throws error of the kind
    /// undecided if the precision is exhausted before the digits are proved.
    state_text at(const exact& time);
    /// The same, with bounds of the errors of the decimals.
    std::vector<proved_decimal> both_at(const exact& time) { return state_at(time); }
    /// One of the two.
    proved_decimal theta_at(const exact& time) { return state_at(time)[0]; }
    proved_decimal omega_at(const exact& time) { return state_at(time)[1]; }
    /// Constants in this order, each digit proved, inf where they are infinite; the radius about a point, without one
    /// about the top, at E = 2 about the bottom.
    std::vector<proved_decimal> constants(const std::vector<motion_constant>& which,
                                          const std::optional<expansion_point>& about = {});

    /// A time as a decimal of this many proved digits: a multiple of the period, of pi, or a fraction.
    std::string time_text(const exact& time, long digits);

    /// Whether the enclosures of theta and omega overlap with those of a second proved route, the sum over separatrix
    /// solutions (on the separatrix the closed formula), when these are narrower than one unit of the last digit. At
    /// rest there is no comparison. Throws error of the kind undecided if they do not become that narrow.
    bool confirms(const exact& time);

private:
    const proved_motion& motion_here();
    std::vector<proved_decimal> state_at(const exact& time);
    std::optional<proved_decimal> exact_constant(motion_constant which) const;
    std::vector<ball> enclosed(const std::vector<motion_constant>& which, const std::optional<expansion_point>& about);
    std::vector<ball> second_route(const exact& time) const;
    long more_digits(const exact& time);

    motion motion_;
    long digits_;
    std::map<long, proved_motion> made_;  ///< by working digits
};

}  // namespace libration::pendulum
