// Lists of coefficients in files, as commands read them.
#pragma once

#include <string>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

/// a_0, a_1, ... of a file, or of stdin for "-". Throws input_error of --coefficients, which names the line.
std::vector<exact> coefficients_in_file(const std::string& path);

/// One list of a file: real where there is no imaginary part.
struct named_list {
    std::string name;  ///< of its column; empty for a file of one list without a name
    std::vector<exact> real;
    std::vector<exact> imaginary;  ///< as many as real, or none

    bool is_complex() const { return !imaginary.empty(); }
};

/// All lists of a file: one for a file as above; below a line of names without `coefficient` one for each column except
/// n and those that end in _uncertainty; NAME_re and NAME_im, and numbers such as 1/2-3i, are complex. JSON is an array
/// of numbers, of pairs [re, im], or of objects with the keys of such columns; numbers may be strings.
/// Throws input_error of --coefficients, which names the line or, of JSON, the row.
std::vector<named_list> lists_in_file(const std::string& path);

}  // namespace libration
