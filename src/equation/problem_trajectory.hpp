// The solution of any differential equation at a list of times as a table.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "option/options.hpp"
#include "text/table.hpp"

namespace libration {

/// The words of --times of a problem: exact numbers without a unit. Throws input_error.
std::vector<exact> times_of_problem(const std::string& words);

/// time,<unknown and its lower derivatives>...,digits,rigour,time_typed.
std::vector<column> columns_of_states(const ode::explicit_system& system);

/// time,<unknown and its lower derivatives>...,digits,rigour,time_typed: in mpfr each value right to one unit in its
/// last digit by two marches that differ in order and in precision (two-method), in fixed scalars as one march computes
/// it (heuristic). in balls each digit proved (problem_reference). Throws input_error for a time that is not
/// reached.
table problem_trajectory(const ode::explicit_system& system, const std::vector<exact>& times,
                         const arithmetic& numbers);

}  // namespace libration
