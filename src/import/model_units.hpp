// The units that a model states, as a comment of the problem, which has none.
#pragma once

#include <sbml/SBMLTypes.h>

#include <string>
#include <vector>

#include "names.hpp"

LIBSBML_CPP_NAMESPACE_USE

namespace libration::import {

/// "# units: t in second, x in mole/litre" and the end of the line, for the time and the quantities with these identifiers; empty if
/// the model states none.
std::string units_line(const Model& model, const std::vector<std::string>& ids, problem_names& names);

}  // namespace libration::import
