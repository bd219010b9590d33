// Data that studies compare with, such as printed values: studies/FOLDER/NAME.csv, embedded in the program.
#pragma once

#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv_records.hpp"

namespace libration::studies {

/// The text of NAME.csv (generated at build time from the files in studies/).
std::string_view data_text(std::string_view name);

/// The cells of a row by the names of their columns.
using data_row = std::map<std::string, std::string>;

/// The rows of NAME.csv.
inline std::vector<data_row> data_table(std::string_view name) {
    std::istringstream text{std::string(data_text(name))};
    csv_records records(text);
    const std::vector<std::string> columns = cells_of(records.next().value().text).value();
    std::vector<data_row> rows;
    while (const auto record = records.next()) {
        const auto cells = cells_of(record->text).value();
        data_row& row = rows.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            row[columns[i]] = cells.at(i);
        }
    }
    return rows;
}

/// The parts of a cell "b = 1; s = 2".
inline std::vector<std::string> parts_of_cell(const std::string& cell) {
    std::vector<std::string> parts;
    std::istringstream text(cell);
    for (std::string part; std::getline(text >> std::ws, part, ';');) {
        parts.push_back(part);
    }
    return parts;
}

}  // namespace libration::studies
