// The pendulum as a problem: its axes, and what they say about a sweep of motions. Times are in sqrt(l/g); T is the
// period of the motion.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/pendulum/energy/period.hpp"
#include "libration/problem/problem.hpp"

namespace libration {

/// An energy of a sweep: E and the gap 2 - E as decimals, exact where they end, else to 50 digits; a decimal that was
/// typed stands as it is. Beside them what was typed, empty for the other of the two.
struct sweep_energy {
    std::string energy;
    std::string gap;
    exact value;  ///< E
    std::string energy_typed;
    std::string gap_typed;
};

/// The energy E, or the one that a gap means. Throws error for what is not an energy (negative, an angle, a multiple of
/// T), of the kind undecided where no precision shows that it is not negative.
sweep_energy energy_from(const exact& energy);
sweep_energy energy_from_gap(const exact& gap);

/// A way to T* as it was typed: agm, series:N or resummed:N.
struct sweep_period_rule {
    pendulum::period_rule rule;
    std::string text;
};

/// Reads one; throws error saying what is wrong.
sweep_period_rule read_period_rule(std::string_view text);

/// The axes energy, gap (which are one coordinate), time, point (fractions of T*, 0 the top, 1 the bottom), periods
/// and period_by.
const problem& pendulum_problem();

/// What the axes of the pendulum say.
struct pendulum_sweep {
    explicit pendulum_sweep(const axis_values& values);

    std::vector<sweep_energy> energies;           ///< by energy and by gap, by size
    std::vector<exact> times;                     ///< multiples of T among them
    std::vector<exact> points;                    ///< fractions of T*
    std::vector<integer> periods;                 ///< whole numbers
    std::vector<sweep_period_rule> period_rules;  ///< ways to T*
};

/// The energies 0 and 2, where a study has no answer, with the reasons; an empty reason leaves that energy in.
std::vector<without_answer> no_answer_at_limits(const std::string& at_rest, const std::string& critical);

}  // namespace libration
