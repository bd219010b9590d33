// Reads the reference tables of tests/reference (made by generate.py, which shares no code with the library).
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace libration::tests {

/// A row: column name to text.
using table_row = std::map<std::string, std::string>;

inline std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

/// All rows of a table, in order. Throws std::runtime_error when the file is missing or a row has other columns.
inline std::vector<table_row> read_table(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) {
        throw std::runtime_error("cannot read " + path);
    }
    const std::vector<std::string> names = split_cells(line);
    std::vector<table_row> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = split_cells(line);
        if (cells.size() != names.size()) {
            throw std::runtime_error("not the columns of the table: " + line);
        }
        table_row row;
        for (std::size_t i = 0; i < names.size(); ++i) {
            row[names[i]] = cells[i];
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

inline std::vector<table_row> reference_table(const std::string& name) {
    return read_table(LIBRATION_REFERENCE_DIR "/" + name);
}

}  // namespace libration::tests
