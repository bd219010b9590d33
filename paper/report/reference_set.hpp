// The published set of reference values, results/reference/: tables that people take into their papers and test suites.
#pragma once

#include <string>
#include <vector>

#include "table/table_order.hpp"

namespace libration {

/// One table of the set: the stem of its files, what it is for, and the order that makes it.
struct reference_table {
    std::string name;
    std::string title;
    table_order order;
};

/// The formats in which each of them is published, with the extensions of their files.
struct reference_format {
    std::string format;
    std::string extension;
};
const std::vector<reference_format>& reference_formats();

const std::vector<reference_table>& reference_set();

/// Writes FOLDER/reference/: every table in every format, and reference.json with the commands and the provenance. In
/// C++ and .ipp the arrays are called libration_NAME. Seconds on two cores. Throws input_error where the folder cannot
/// be written.
void write_reference_set(const std::string& folder, int jobs);

}  // namespace libration
