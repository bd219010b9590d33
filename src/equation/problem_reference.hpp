// Proved digits of the solution of any differential equation at a list of times, as a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"
#include "text/table.hpp"

namespace libration {

/// What was proved at a list of times, and why the rest was not.
struct partial_table {
    /// A row for each time that is reached: time,<unknown and its lower derivatives>...,digits,rigour,time_typed. A value
    /// that no run within the limits distinguishes from 0 is an empty cell, and then a column `undecided` behind has its
    /// bound, "|y| < 1.2e-60", where there are several "|y| < 1.2e-60; |z| < 3e-61".
    table rows;
    /// The same for people: each time a paragraph, each value or its bound a line.
    std::string text;
    std::optional<error> missing;

    /// Whether there is something to write: not where the first time is missing already.
    bool has_output() const { return !missing || !rows.rows().empty(); }
};

/// Throws the error of what is missing, once the rest has been written.
void require_complete(const partial_table& of);

/// Each value right to one unit in its last digit (ode::proved_part_of_trajectory); progress on a terminal. With `check`
/// each is compared with a second proof (ode::proof_route::second): throws std::runtime_error with both enclosures where
/// they disagree.
partial_table problem_reference(const ode::explicit_system& system, const std::vector<exact>& times, long digits,
                                bool check = false);

/// States for people: each time a paragraph, each column a line.
std::string lines_of_states(const table& data);

}  // namespace libration
