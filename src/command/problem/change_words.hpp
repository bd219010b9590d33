// The arguments of --set: changes of a problem.
#pragma once

#include <string>

#include "libration/equation/equation_system.hpp"

namespace libration {

/// Throws for a change such as `kk=1` or `f'''(0)=1` whose left-hand side is neither a parameter nor an initial value
/// of the problem, with the similar one and all that exist. Throws input_error; other forms are accepted.
void require_changeable(const ode::equation_system& system, const std::string& change);

}  // namespace libration
