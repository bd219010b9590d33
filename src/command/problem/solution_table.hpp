// The states of a solution as a table: the output of reference and trajectory for every problem.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "problem_options.hpp"
#include "text/table.hpp"

namespace libration {

/// Significant digits of the column invariant_drift.
inline constexpr long digits_of_drift = 3;

/// Cells shared by all times of a solution, with the names of their columns, by position in a row.
struct shared_cells {
    using list = std::vector<std::pair<const char*, cell>>;
    list before_time, behind_values, behind_rigour, behind_time;
};

/// The results at a list of times, and the reason why the rest is missing.
struct partial_table {
    /// A row for each time that is reached: <before_time>...,time,<quantity>...,<behind_values>...,digits,rigour,
    /// <behind_rigour>...,time_typed,<behind_time>.... If invariants are known and nothing is proved, the following
    /// column `invariant_drift` is the largest change of one of them since the initial point, of the values before they
    /// are rounded for printing. A value that no run within the limits distinguishes from 0, or that its equations do
    /// not reach, is an empty cell, and then a further column `undecided` has "|y| < 1.2e-60; z is not reached".
    table rows;
    /// The same as readable text: the shared cells in separate lines, then a paragraph per time, with a line for each
    /// value or its bound.
    std::string heading, text;
    std::optional<error> missing;
    std::vector<ode::collocation_use> collocation = {};  ///< answer::collocation
    std::vector<answer_note> notes = {};                 ///< answer::notes

    /// Whether there is something to write: false if the first time is missing already.
    bool has_output() const { return !missing || !rows.rows().empty(); }
};

/// The tables of a family of solutions, one below the other, with the values that distinguish them in the first columns;
/// columns that not all of them have are left out. What the first table misses is missing.
partial_table family_table(const std::vector<family_member>& family, const std::vector<partial_table>& parts);

/// Throws the error of what is missing, once the rest has been written, with the notes on stderr.
void require_complete(const partial_table& of);

/// Whether a value of it has no digits.
bool has_undecided(const answer& found);

/// What is known of the values of a row that have no digits: "|y| < 1.2e-60; z is not reached".
std::string bounds_of(const answer& found, const std::vector<answer_value>& row);

/// The results at these times, with `decimals` as they are printed.
partial_table states_table(const answer& found, const std::vector<exact>& times,
                           const std::vector<std::string>& decimals, long digits, const shared_cells& shared = {});

/// The states of a solution.
partial_table states_table(const solution& of, const std::vector<exact>& times, const request& how,
                           const shared_cells& shared = {});

/// Events, each in a row: time,<quantity>...,digits,rigour,count; then `undecided` as for states.
partial_table events_table(const answer& found, long digits);

/// States as readable text: a paragraph per time, a line per column.
std::string lines_of_states(const table& data);

/// Tables of several solutions with the same columns, one below the other; a heading that equals the previous one is
/// not repeated.
partial_table stacked_states(const std::vector<partial_table>& parts);

}  // namespace libration
