// Models of SBML as problems.
#pragma once

#include <sbml/SBMLTypes.h>

#include <string>

LIBSBML_CPP_NAMESPACE_USE

namespace libration::import {

/// The text of a problem with the solution of the model: reactions, rate, assignment and algebraic rules, constant
/// delays, events, also with a delay. A species is its concentration, or its amount if the model states so. Functions and local
/// parameters have to be expanded before. Throws unsupported.
std::string model_text(Model& model);

}  // namespace libration::import
