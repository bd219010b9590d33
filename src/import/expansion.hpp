// Functions of a model, replaced by their bodies, and local parameters by global ones. libsbml does this only for models that pass all its
// checks, which many published ones do not.
#pragma once

#include <sbml/SBMLTypes.h>

LIBSBML_CPP_NAMESPACE_USE

namespace libration::import {

/// Replaces calls of function definitions by their bodies. Throws unsupported for a function that is not defined, has another number
/// of arguments, or calls itself.
void expand_functions(Model& model);

/// Makes local parameters of reactions parameters of the model, REACTION_NAME.
void promote_local_parameters(Model& model);

/// Whether a piecewise function of the model has no value for all other cases.
bool has_open_piecewise(Model& model);

}  // namespace libration::import
