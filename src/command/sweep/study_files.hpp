// The files of a study: CSV and LaTeX tables, the figures drawn from the CSV, and the JSON that names them all.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sweep/cell_engine.hpp"
#include "sweep/study.hpp"
#include "sweep/study_figures.hpp"
#include "sweep/study_order.hpp"

namespace libration {

/// Writes the tables and figures of the cells that a store contains for the order to DIR/NAME, as make_study
/// (study_run.hpp) does. Cells that it does not contain count as failed.
failures_found make_tables(const study_order& order, const study_cells& of, cell_store& store,
                           const std::string& folder);

/// Throws input_error of --columns for names that none of the tables has.
void require_columns(const std::vector<study_table>& tables, const std::optional<std::string>& names);

/// Redraws the figures in DIR/NAME from the tables named in NAME.json. Throws input_error if one of them is missing or
/// differs from the one described in NAME.json, or if gnuplot is missing.
void draw_study(const study& what, const std::string& folder);

/// Writes one file of a results directory, completely or not at all. Throws input_error of --out.
void write_into(const std::string& path, const std::string& content);

/// The study of that name; throws input_error that lists the existing names.
const study& study_named(std::string_view option, std::string_view name);

}  // namespace libration
