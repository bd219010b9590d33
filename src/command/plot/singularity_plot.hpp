// The figure of `libration singularities --plot`: the map of the complex plane.
#pragma once

#include <string>

#include "plot/figure_file.hpp"
#include "text/table.hpp"

namespace libration {

/// The singularities about the initial point t0 in the complex plane, a mark for each kind, solid if its position is
/// proved, with the circle about t0 through the nearest. `found` has the columns of the command; t0 is a
/// decimal.
figure_content singularity_plot(const table& found, const std::string& initial_point, const std::string& problem);

}  // namespace libration
