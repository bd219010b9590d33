// Proved digits of the solution of any differential equation at a list of times, as a table.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/exact.hpp"
#include "text/table.hpp"

namespace libration {

/// time,<unknown and its lower derivatives>...,digits,rigour,time_typed, each value right to one unit in its last digit
/// (ode::proved_trajectory); progress on a terminal. Throws error of the kind undecided for a time that is not reached,
/// which says up to which time the solution is proved to exist. With `check` each value is compared with a second proof
/// (ode::proof_route::second): throws std::runtime_error with both enclosures where they disagree.
table problem_reference(const ode::explicit_system& system, const std::vector<exact>& times, long digits,
                        bool check = false);

/// States for people: each time a paragraph, each column a line.
std::string lines_of_states(const table& data);

}  // namespace libration
