// The words of --set: what a problem has to be changed.
#pragma once

#include <string>

#include "libration/ode/equation_system.hpp"

namespace libration {

/// Refuses a change such as `kk=1` or `f'''(0)=1` whose left side is no parameter and no start of the problem, with the
/// near one and those that there are. Throws input_error; what is no such form passes.
void require_changeable(const ode::equation_system& system, const std::string& change);

}  // namespace libration
