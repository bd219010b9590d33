// The pendulum as a problem: its axes, and the sweep of motions that they define. Times are in sqrt(l/g); T is the
// period of the motion.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/pendulum/period.hpp"
#include "libration/problem/problem_family.hpp"

namespace libration {

/// An energy of a sweep: E and the gap 2 - E as decimals, exact if they terminate, else to 50 digits; a decimal is
/// unchanged as given. In addition the text that was given, empty for the other of the two.
struct sweep_energy {
    std::string energy;
    std::string gap;
    exact value;  ///< E
    std::string energy_typed;
    std::string gap_typed;
};

/// The energy E, or the one given by a gap. Throws error for an invalid energy (negative, an angle, a multiple of
/// T), of the kind undecided if no precision shows that it is not negative.
sweep_energy energy_from(const exact& energy);
sweep_energy energy_from_gap(const exact& gap);

/// A method for T* as given: agm, series:N or resummed:N.
struct sweep_period_rule {
    pendulum::period_rule rule;
    std::string text;
};

/// Parses one; throws error with the reason if it is invalid.
sweep_period_rule read_period_rule(std::string_view text);

/// The axes energy, gap (which are one coordinate), time, point (fractions of T*, 0 the top, 1 the bottom), periods
/// and period_by.
const problem_family& pendulum_problem();

/// The values on the axes of the pendulum.
struct pendulum_sweep {
    explicit pendulum_sweep(const axis_values& values);

    std::vector<sweep_energy> energies;           ///< by energy and by gap, by size
    std::vector<exact> times;                     ///< may be multiples of T
    std::vector<exact> points;                    ///< fractions of T*
    std::vector<integer> periods;                 ///< whole numbers
    std::vector<sweep_period_rule> period_rules;  ///< methods for T*
};

/// The energies 0 and 2, at which a study is not defined, with the reasons; an empty reason includes that energy.
std::vector<without_answer> no_answer_at_limits(const std::string& at_rest, const std::string& critical);

}  // namespace libration
