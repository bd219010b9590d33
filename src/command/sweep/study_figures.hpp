// The figures of a study: NAME.gp draws them from the tables of one run.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sweep/study.hpp"

namespace libration {

/// Draws the figures of the tables NAME*.csv in a directory into that directory, SVG, PDF and PNG, complete and
/// finished (sweep/image.hpp). Throws input_error if gnuplot is missing and std::runtime_error if a drawing fails or is
/// cut short; then none of them is left there.
void draw_figures(const study& what, const std::string& folder);

/// The variables of a figure script, with their texts.
using script_variables = std::vector<std::pair<std::string, std::string>>;

/// Runs SCRIPT.gp of studies_folder() or a directory below it on the tables in a directory, and finishes the figures
/// that it draws there, in all of the kinds (svg, pdf, png). Throws as draw_figures.
void draw_by_script(const std::string& script, const script_variables& variables, const std::vector<std::string>& kinds,
                    const std::string& folder);

/// The kinds of figures: "svg", "pdf", "png".
const std::vector<std::string>& figure_kinds();

/// Whether a file has the name of a figure.
bool is_figure(const std::string& file);

/// The directory of the figure scripts and of the errata's template: in the source tree, or next to an installed
/// program.
std::string studies_folder();

}  // namespace libration
