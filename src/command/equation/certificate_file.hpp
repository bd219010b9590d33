// The file of --certificate: from it a program in integers proves the printed values (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/problem/answer.hpp"
#include "libration/scalar/exact.hpp"
#include "text/table.hpp"

namespace libration {

/// The compressed certificate that each value of a table of states, a row per time, differs from the exact one by less
/// than one unit of its last digit. Throws input_error for a problem or a time that the format does not contain, and
/// error of the kind undecided if the values are not proved by collocation.
std::string certificate_of_states(const std::string& path, const ode::explicit_system& system,
                                  const std::vector<exact>& times, const table& states, const request& how);

/// Writes it to a file. Throws input_error.
void write_certificate(const std::string& path, const std::string& content);

}  // namespace libration
