// Tables of text: every number is already a decimal string, so nothing is rounded on its way out.
#pragma once

#include <string>
#include <vector>

namespace libration {

/// A column: its CSV name, and its unit or meaning for the reader of the JSON beside a study.
struct column {
    std::string name;
    std::string meaning;
};

/// Rows of cells under columns; every row has as many cells as there are columns.
struct table {
    std::vector<column> columns;
    std::vector<std::vector<std::string>> rows;
};

/// One header line, one row a line, no comments.
std::string to_csv(const table& data);

/// Reads what to_csv wrote: cells may be quoted, and hold commas, quotes and line ends then. The meanings of the
/// columns stay empty. Throws std::runtime_error naming the line where a row has another number of cells than the
/// header.
table from_csv(const std::string& text);

/// An array of objects of strings with the keys of the CSV.
std::string to_json(const table& data);

/// Aligned columns for a terminal.
std::string to_text(const table& data);

/// Writes the whole file or nothing: beside the target first, then renamed onto it. A symbolic link is followed; what
/// exists and is no regular file (a pipe, a device) is written to as it is.
/// Throws std::runtime_error with the reason; nothing is left behind then.
void write_whole_file(const std::string& path, const std::string& content);

/// Writes to stdout and sees that it arrives. Throws std::runtime_error with the reason.
void write_to_stdout(const std::string& content);

}  // namespace libration
