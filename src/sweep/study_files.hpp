// The files of a study: CSV and LaTeX tables, the JSON beside them, and the figures drawn from the CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sweep/study.hpp"
#include "sweep/study_order.hpp"

namespace libration {

/// Runs the study and writes DIR/NAME/NAME[_SUFFIX].csv, the same as .tex, and DIR/NAME/NAME.json. Throws input_error
/// when DIR cannot be written.
void write_study(const study_order& order, const std::string& folder);

/// Draws DIR/NAME/*.svg and *.png from the CSV with studies/NAME.gp. Throws input_error when the CSV or gnuplot is
/// missing.
void draw_study(const study& what, const std::string& folder);

/// The folder of the figure scripts and of the errata's outline: in the source tree, or beside an installed program.
std::string studies_folder();

/// Writes one file of a results folder, whole or not at all. Throws input_error of --out.
void write_into(const std::string& path, const std::string& content);

/// The study of that name; throws input_error that lists the names there are.
const study& study_named(std::string_view option, std::string_view name);

}  // namespace libration
