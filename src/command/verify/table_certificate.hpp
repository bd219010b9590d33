// verify --certificate: a certificate of the solution at the times of a table.
#pragma once

#include <string>

#include "problem/problem_options.hpp"
#include "text/column_names.hpp"

namespace libration {

/// Writes the certificate of all unknowns at the times of a file, each time once, with which check/compare.py compares the file without
/// this program. Rows whose times cannot be read are left out. Throws input_error for stdin, and as certify_states().
void certify_times_of_table(const std::string& path, const problem_options& problem, const std::string& file,
                            const column_names& names, bool times_are_doubles);

}  // namespace libration
