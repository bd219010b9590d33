// The figures of a study: NAME.gp draws them from the tables of one run.
#pragma once

#include <string>
#include <vector>

#include "sweep/study.hpp"

namespace libration {

/// Draws the figures of the tables NAME*.csv in a folder into that folder, SVG, PDF and PNG, whole and finished
/// (sweep/image.hpp). Throws input_error when gnuplot is missing and std::runtime_error when a drawing fails or is cut
/// short; then none of them is left there.
void draw_figures(const study& what, const std::string& folder);

/// Whether a file is one of those that a figure is drawn into.
bool is_figure(const std::string& file);

/// The folder of the figure scripts and of the errata's outline: in the source tree, or beside an installed program.
std::string studies_folder();

}  // namespace libration
