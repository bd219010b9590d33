// Tables of numbers for programs: a C++ header, Boost.Math's .ipp, and text that NumPy reads, each with its
// provenance. All cells are decimals and stand as they are, so that no digit is lost.
#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace libration {

/// What a table of numbers says about itself: its name in a program, and the lines of its comment.
struct table_origin {
    std::string name;
    std::vector<std::string> lines;
};

/// Throws input_error of --name for what is no identifier of C++.
void require_identifier(const std::string& name);

/// A header of its own (C++17): struct NAME_row with a const char* a column, and the constexpr array NAME of them. inf
/// and -inf stand as such, as strtod and mpfr_set_str read them.
std::string to_cpp_header(const table& data, const table_origin& origin);

/// A static array of arrays in the form of Boost.Math's test data [boost/libs/math/test]: needs SC_ or T,
/// table_type<T> and BOOST_JOIN in sight. Throws input_error for a cell that is infinite: test data of that form holds
/// none.
std::string to_ipp(const table& data, const table_origin& origin);

/// Columns of numbers under comments, as numpy.loadtxt and genfromtxt read them; the last comment names the columns.
std::string to_numpy(const table& data, const table_origin& origin);

}  // namespace libration
