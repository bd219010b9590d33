// Tables of numbers for programs: headers for C++ and C, Boost.Math's .ipp, a Fortran module, text that NumPy, Julia
// and PARI/GP read, each with its provenance. All cells are decimals and are written unchanged, so that no digit is
// lost.
#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace libration {

/// The description of a table of numbers: its name in a program, and the lines of its comment.
struct table_origin {
    std::string name;
    std::vector<std::string> lines;
};

/// Throws input_error of --name for a name that is not a C++ identifier.
void require_identifier(const std::string& name);

/// Whether a format is one of these: cpp, ipp, numpy, c, fortran, julia or pari.
bool is_program_format(const std::string& format);

/// The table in one of these formats. Throws input_error for a cell that is infinite if the format is ipp: Boost.Math's
/// test data holds none.
std::string program_text(const std::string& format, const table& data, const table_origin& origin);

}  // namespace libration
