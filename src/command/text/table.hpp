// Tables: columns with a meaning, and rows of typed cells that fit them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "text/cell.hpp"

namespace libration {

/// A column: its CSV name, and its unit or meaning for the reader of the JSON file of a study.
struct column {
    std::string name;
    std::string meaning;
};

using table_row_cells = std::vector<cell>;

/// Rows of cells under columns; every row has as many cells as there are columns.
class table {
public:
    table() = default;
    explicit table(std::vector<column> columns) : columns_(std::move(columns)) {}
    /// Throws std::logic_error as add_row does.
    table(std::vector<column> columns, std::vector<table_row_cells> rows);

    const std::vector<column>& columns() const { return columns_; }
    const std::vector<table_row_cells>& rows() const { return rows_; }

    /// Throws std::logic_error for a row that has another number of cells than there are columns: a mistake of the
    /// program, not of its user.
    void add_row(table_row_cells row);
    /// The rows of another table below its own. Throws std::logic_error where their columns have other names.
    void append(const table& below);
    /// The columns of these places alone, in this order.
    table with_columns(const std::vector<std::size_t>& places) const;
    /// The columns that hold no JSON arrays.
    table without_lists() const;

private:
    std::vector<column> columns_;
    std::vector<table_row_cells> rows_;
};

/// Tables with the same columns, one below the other. Throws std::logic_error for no table at all.
table stacked(const std::vector<table>& parts);

/// The same for several tables a part: the k-th of the result stacks the k-th of every part.
std::vector<table> stacked(const std::vector<std::vector<table>>& parts);

/// A column of a table whose rows are made of a Row: name, meaning and value in one place.
template <class Row>
struct column_of {
    std::string name;
    std::string meaning;
    std::function<cell(const Row&)> value;
};

template <class Row>
using column_list = std::vector<column_of<Row>>;

/// The lists of several columns as one.
template <class Row>
column_list<Row> joined(column_list<Row> first, const column_list<Row>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The columns of these names, "a,b,c", in this order. Throws std::logic_error for a name that none has.
template <class Row>
column_list<Row> columns_named(const std::string& names, const column_list<Row>& all) {
    column_list<Row> chosen;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
        if (found == all.end()) {
            throw std::logic_error("no column is called " + name);
        }
        chosen.push_back(*found);
    }
    return chosen;
}

/// The columns with other meanings, by name, where rows of another kind have another unit. Throws std::logic_error for a
/// name that none has.
template <class Row>
column_list<Row> with_meanings(column_list<Row> columns, const std::map<std::string, std::string>& meanings) {
    for (const auto& [name, meaning] : meanings) {
        const auto found = std::ranges::find(columns, name, &column_of<Row>::name);
        if (found == columns.end()) {
            throw std::logic_error("the table has no column " + name);
        }
        found->meaning = meaning;
    }
    return columns;
}

/// The columns of Part, which a Row holds as the member `part`.
template <class Row, class Part>
column_list<Row> columns_within(const column_list<Part>& columns, Part Row::*part) {
    column_list<Row> result;
    result.reserve(columns.size());
    for (const column_of<Part>& each : columns) {
        result.push_back(
            {each.name, each.meaning, [value = each.value, part](const Row& r) { return value(r.*part); }});
    }
    return result;
}

/// The table of these rows: it fits by construction.
template <class Row>
table make_table(const column_list<Row>& columns, const std::vector<Row>& rows) {
    std::vector<column> heads;
    heads.reserve(columns.size());
    for (const column_of<Row>& each : columns) {
        heads.push_back({each.name, each.meaning});
    }
    table result(std::move(heads));
    for (const Row& row : rows) {
        table_row_cells cells;
        cells.reserve(columns.size());
        for (const column_of<Row>& each : columns) {
            cells.push_back(each.value(row));
        }
        result.add_row(std::move(cells));
    }
    return result;
}

/// One header line, one line per row, no comments.
std::string to_csv(const table& data);

/// The objects of a cell that is a JSON array, as rows under their keys.
table table_of_list(const cell& list);

/// The CSV of a table that is too long to be held: row by row into a file, with these of its columns.
class csv_stream {
public:
    csv_stream(const std::string& path, const std::vector<column>& columns, std::vector<std::size_t> places);
    void add(const table_row_cells& row);
    /// Throws std::runtime_error where not all of it could be written.
    void finish();

private:
    std::string path_;
    std::vector<std::size_t> places_;
    std::ofstream file_;
};

/// Reads what to_csv wrote: cells may be quoted, and hold commas, quotes and line ends then. The meanings of the
/// columns stay empty; a cell is a number where one is written. Throws std::runtime_error naming the line where a row
/// has another number of cells than the header.
table from_csv(const std::string& text);

/// An array of objects of strings with the keys of the CSV.
std::string to_json(const table& data);

/// Aligned columns for a terminal.
std::string to_text(const table& data);

/// Writes the whole file or nothing: to a temporary file next to the target, which is then renamed. A symbolic link is
/// followed; an existing target that is not a regular file (a pipe, a device) is written to directly.
/// Throws std::runtime_error with the reason, and removes the temporary file.
void write_whole_file(const std::string& path, const std::string& content);

/// Writes to stdout and checks that it was written. Throws std::runtime_error with the reason.
void write_to_stdout(const std::string& content);

}  // namespace libration
