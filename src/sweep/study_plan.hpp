// A study as a list of independent cells: exact inputs, and the rows that follow from them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "journal/cell_text.hpp"
#include "libration/scalar/dispatch.hpp"
#include "text/table.hpp"

namespace libration {

/// One CSV of a study: its name is the study's, with _SUFFIX where there are several.
struct study_table {
    std::string suffix;
    scalar_spec scalar;
    table data;
    bool timed = false;    ///< holds times of this machine: its bytes differ from run to run
    bool written = true;   ///< false: for study_plan::derive alone
    std::size_t rows = 0;  ///< that were written to its file, where data is without them because they are too many
};

/// An exact input of a cell: the name of its axis, and its words as they were typed or as a range made them.
struct cell_input {
    std::string axis;
    std::string words;
};
using cell_inputs = std::vector<cell_input>;

/// Cells that share work, as the orders of one series do: of one that was added to those computed before, only the
/// missing are computed.
struct cell_group {
    std::vector<cell_inputs> cells;  ///< at least one; no two are the same
    /// The rows of these of the cells, in this order. The rows of a cell depend on its inputs alone, not on what is
    /// computed with it.
    std::function<std::vector<cell_rows>(const std::vector<std::size_t>& which)> compute;
};

/// What a study is asked for, as cells in the order in which their rows stand in the tables. Nothing is computed until
/// a group is, and groups are made when they are needed: a plan of a million cells is small.
struct study_plan {
    std::vector<study_table> tables;  ///< without rows
    /// The axes along which the cells differ. The values of all other axes of the request are inputs of every cell.
    std::vector<std::string> axes;
    std::size_t groups = 0;
    std::function<cell_group(std::size_t)> group;  ///< safe to call from several threads
    /// What a group is expected to cost, in any unit, so that the longest come first; empty: all the same.
    std::function<double(std::size_t)> cost;
    /// Makes what follows from whole tables: all tables with the rows of the cells go in. Empty: nothing does.
    std::function<void(std::vector<study_table>&)> derive;
};

/// A table without rows under the columns of a Row.
template <class Row>
study_table head_of(std::string suffix, const scalar_spec& scalar, const column_list<Row>& columns) {
    return {std::move(suffix), scalar, make_table(columns, std::vector<Row>())};
}

/// The rows of these tables as those of one cell.
cell_rows rows_of(const std::vector<table>& tables);

/// A plan whose groups are single cells: inputs(i) and rows(i), which gives one table for each of the plan's.
study_plan plan_of_cells(std::vector<study_table> tables, std::vector<std::string> axes, std::size_t cells,
                         std::function<cell_inputs(std::size_t)> inputs,
                         std::function<std::vector<table>(std::size_t)> rows);

/// The inputs with one more.
cell_inputs with_input(cell_inputs inputs, std::string axis, std::string words);

/// The rows of tables in which each of `count` cells has as many rows as the others, one cell after the other. Throws
/// std::logic_error where they do not come out even.
std::vector<cell_rows> equal_parts(const std::vector<table>& tables, std::size_t count);

}  // namespace libration
