// The head of a certificate: equations, initial values and the unknowns that the polynomial form adds, as text.
#pragma once

#include <string>
#include <vector>

#include "certificate.hpp"
#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// The names of the unknowns and their lower derivatives, and of the derivatives of these by the varied start.
std::vector<std::string> certified_names(const explicit_system& system, const certified_statement& statement);

/// The lines `variable`, `at`, `equation`, `start`, `vary`, `define` and `condition` of a certificate. Throws error of the kind
/// argument and the subject "certificate" if the format does not contain the problem.
std::string problem_of_certificate(const explicit_system& system, const polynomial_form& form,
                                   const certified_statement& statement);

/// Whether the condition holds at the initial point. Throws the same error if the program that checks does not see it.
bool holds_at_start(const explicit_system& system, const expression& condition);

}  // namespace libration::ode
