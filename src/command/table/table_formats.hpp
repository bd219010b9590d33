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

/// A self-contained header (C++17): struct NAME_row with a const char* per column, and the constexpr array NAME of
/// them. inf and -inf are written as such, as strtod and mpfr_set_str read them.
std::string to_cpp_header(const table& data, const table_origin& origin);

/// A static array of arrays in the form of Boost.Math's test data [boost/libs/math/test]: needs SC_ or T,
/// table_type<T> and BOOST_JOIN in sight. Throws input_error for a cell that is infinite: test data of that form holds
/// none.
std::string to_ipp(const table& data, const table_origin& origin);

/// A header of C99: struct NAME_row with a const char* a column, the array NAME of them, and NAME_rows, their number.
std::string to_c_header(const table& data, const table_origin& origin);

/// A module NAME of Fortran 2003, free form: character arrays of NAME_rows elements, one a column, whose elements
/// read(x(i), *) takes into any kind. Of two names that Fortran does not tell apart, as k and K, the second ends in
/// _value.
std::string to_fortran(const table& data, const table_origin& origin);

/// A NamedTuple NAME of Julia with a vector of strings a column: parse.(BigFloat, NAME.theta).
std::string to_julia(const table& data, const table_origin& origin);

/// A matrix NAME of PARI/GP with a row a row, whose numbers have all digits that are written; oo where one is infinite.
std::string to_pari(const table& data, const table_origin& origin);

/// Columns of numbers under comments, as numpy.loadtxt and genfromtxt read them; the last comment names the columns.
std::string to_numpy(const table& data, const table_origin& origin);

/// The writer of a format: cpp, ipp, numpy, c, fortran, julia or pari; nullptr for another one.
using table_writer = std::string (*)(const table& data, const table_origin& origin);
table_writer writer_of(const std::string& format);

}  // namespace libration
