// Unknown parameters and initial values of a problem, and its periodic orbits, each proved to exist.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"

namespace libration {

/// The parameters or initial values k, f''(0) for which as many conditions f'(5) = 1 hold, near the values that the
/// problem has, each digit proved: name and value, a row for each. A single condition at infinity, f'(inf) = 1, is
/// decided by a lemma about the problem (proved_for_infinity), and may determine several. With request.check the
/// values are compared with a second proof: throws std::runtime_error with both enclosures if they disagree. Of the
/// callbacks only request.reached is called, which may throw to end the search: what it throws reaches the caller.
/// Throws error of the subjects "conditions" for conditions, "condition" for one at infinity, "unknowns" for unknowns
/// that it cannot determine, and of the kind undecided for a condition at infinity without a lemma.
answer find_unknowns(const problem& of, const std::vector<std::string>& unknowns,
                     const std::vector<std::string>& conditions, const request& how);

/// The periodic orbit near the initial values of an autonomous problem: the unknowns and their lower derivatives on a
/// section, and `period`; name and value, a row for each, each digit proved, compared and watched as above. Throws
/// error like ode::proved_periodic_orbit.
answer find_periodic_orbit(const problem& of, const request& how);

}  // namespace libration
