// Eigenvalues of wells as answers.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/find.hpp"

namespace libration {

/// The eigenvalue near the value that the problem has; the lowest one without a first guess.
answer well_found(const problem& of, const std::string& energy, const std::vector<std::string>& conditions,
                  const request& how, bool without_guess);

}  // namespace libration
