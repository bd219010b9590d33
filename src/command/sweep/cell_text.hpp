// The rows of a cell as compact text, as a journal keeps them and a rank sends them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/table.hpp"

namespace libration {

/// What a cell of a study makes: the rows of each of the study's tables, by the place of the table.
using cell_rows = std::vector<std::vector<table_row_cells>>;

/// The rows, every cell with its kind and its digits, so that rows_from gives back what went in.
std::string to_cell_text(const cell_rows& rows);

/// Throws std::runtime_error for what to_cell_text did not write.
cell_rows rows_from(std::string_view text);

}  // namespace libration
