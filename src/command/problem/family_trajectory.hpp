// The solutions of a family of problems at a list of times in double.
#pragma once

#include <optional>
#include <vector>

#include "libration/number/exact.hpp"
#include "problem_options.hpp"
#include "solution_table.hpp"

namespace libration {

/// The states of each member of a family like those of problem_trajectory in double, in lock step (ode::batch_march) on
/// so many threads, with the changes of invariants. Nothing for a member whose solution does not reach all times, which
/// its own integration explains, and for all members if the problem cannot be integrated with these values as
/// variables: if one of them has to be a constant of the equations, as an exponent has, or the initial point is
/// singular. Throws error of the kind undecided if the command is to end.
std::vector<std::optional<partial_table>> family_in_lock_step(const std::vector<family_member>& family,
                                                              const std::vector<exact>& times, long digits, int jobs);

}  // namespace libration
