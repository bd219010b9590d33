// The eigenvalues of `find --eigenvalue`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "found_solutions.hpp"
#include "problem/problem_options.hpp"

namespace libration {

/// What is typed.
struct eigenvalue_request {
    std::string energy;
    std::optional<std::string> count;
    std::vector<std::string> conditions;  ///< at infinity
    long digits;
    bool check;
};

/// The first eigenvalues as one solution. Throws input_error, and error like find_eigenvalues.
found_solutions found_eigenvalues(const eigenvalue_request& typed, const problem_options& problem);

}  // namespace libration
