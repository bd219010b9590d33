// First values of unknowns: those that options give, and those that a search tries.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "found_solutions.hpp"
#include "libration/problem/find.hpp"
#include "problem/problem_options.hpp"

namespace libration {

/// The values from which a search begins, with the options that give them.
std::vector<std::pair<std::string, std::string>> first_values(const first_guess& guess,
                                                              const std::optional<branch_values>& along);

/// Throws input_error for an unknown parameter that the problem leaves open and that no option gives.
void require_first_values(const problem_options& problem, const std::vector<std::string>& unknowns,
                          const first_guess& guess, const std::optional<branch_values>& along);

/// Adds the value 1 of each unknown that has none, where several are tried, and returns these unknowns.
std::vector<std::string> add_first_values(const problem_options& problem, const std::vector<std::string>& unknowns,
                                          first_guess& guess);

}  // namespace libration
