// Names for expressions in the variable and the unknowns, as r = k*x*y.
#pragma once

#include <set>
#include <string>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// The names of definitions that depend on the variable or on unknowns, directly or through other definitions.
std::set<std::string> shorthands_of(const equation_system& system);

/// Replaces these names by their expressions everywhere, in the definitions too. Throws error for definitions that
/// depend on each other cyclically.
void replace_shorthands(equation_system& in);

}  // namespace libration::ode
