// A file of columns as people and programs write it: comma-separated, with semicolons, tabulators or blanks, its names
// in the first line, in a comment before it (numpy.savetxt), or nowhere.
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "text/csv_records.hpp"

namespace libration {

/// A file, or stdin for "-".
class input_stream {
public:
    /// `option` is what named the file in the command line. Throws input_error where it cannot be read.
    input_stream(const std::string& option, const std::string& path);
    std::istream& in();
    /// What messages call it.
    const std::string& name() const { return name_; }
    /// The same with what named it: "--points 'file'".
    std::string title() const;

private:
    std::string option_, name_;
    std::ifstream file_;
};

/// Names, and records of as many cells below them, in constant memory. Lines that begin with # are comments.
///
/// The separator is that of the first line that is not a comment. That line holds the names unless all of its cells are
/// numbers: then the names are in the last comment before it, if that has as many, or there are none.
class column_file {
public:
    /// Reads as far as the first record. Throws input_error as csv_records::next().
    explicit column_file(input_stream& source);

    /// Empty where the file has none.
    const std::vector<std::string>& names() const { return names_; }
    /// Cells of the first line; 0 for a file without one.
    std::size_t count() const { return count_; }
    separator between() const { return between_; }
    /// Whether there is a record; asked before the first next().
    bool has_records() const { return first_.has_value(); }

    std::optional<csv_record> next();
    /// std::nullopt if a quote is not closed.
    std::optional<std::vector<std::string>> cells(const csv_record& record) const {
        return cells_of(record.text, between_);
    }

private:
    csv_records records_;
    separator between_ = separator::comma;
    std::vector<std::string> names_;
    std::size_t count_ = 0;
    std::optional<csv_record> first_;  // read already
};

}  // namespace libration
