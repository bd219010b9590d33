// The head of a certificate: equations, initial values and the unknowns that the polynomial form adds, as text.
#pragma once

#include <string>

#include "libration/ode/lifted_system.hpp"

namespace libration::ode {

/// The lines `variable`, `at`, `equation`, `start` and `define` of a certificate. Throws error of the kind argument and
/// the subject "certificate" if the format does not contain the problem.
std::string problem_of_certificate(const explicit_system& system, const lifted_system& form);

}  // namespace libration::ode
