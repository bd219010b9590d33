// The states of a solution as a table: what reference and trajectory print of every problem.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"
#include "text/table.hpp"

namespace libration {

/// Cells that all times of a solution share, with the names of their columns, by where they are in a row.
struct shared_cells {
    using list = std::vector<std::pair<const char*, cell>>;
    list before_time, behind_values, behind_rigour, behind_time;
};

/// What is answered at a list of times, and why the rest is not.
struct partial_table {
    /// A row for each time that is reached: <before_time>...,time,<quantity>...,<behind_values>...,digits,rigour,
    /// <behind_rigour>...,time_typed,<behind_time>.... Where invariants are known and nothing is proved, the column
    /// `invariant_drift` behind is the largest change of one of them since the start, of the values before they are
    /// rounded to be printed. A value that no run within the limits distinguishes from 0, or that its equations do not
    /// reach, is an empty cell, and then a column `undecided` behind has "|y| < 1.2e-60; z is not reached".
    table rows;
    /// The same for people: the shared cells in lines of their own, then each time a paragraph, each value or its bound
    /// a line.
    std::string heading, text;
    std::optional<error> missing;

    /// Whether there is something to write: not where the first time is missing already.
    bool has_output() const { return !missing || !rows.rows().empty(); }
};

/// Throws the error of what is missing, once the rest has been written.
void require_complete(const partial_table& of);

/// The answer at these times, which stand in `decimals` as they are printed.
partial_table states_table(const answer& found, const std::vector<exact>& times,
                           const std::vector<std::string>& decimals, long digits, const shared_cells& shared = {});

/// The states of a solution.
partial_table states_table(const solution& of, const std::vector<exact>& times, const request& how,
                           const shared_cells& shared = {});

/// States for people: each time a paragraph, each column a line.
std::string lines_of_states(const table& data);

/// Tables of several solutions with the same columns, one below the other; a heading that is that of the one before is
/// not repeated.
partial_table stacked_states(const std::vector<partial_table>& parts);

}  // namespace libration
