// The figure of `libration radius --plot`: what the coefficients show about the nearest singularity.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/series_request.hpp"
#include "plot/figure_file.hpp"

namespace libration {

/// For each of the unknowns, four at most, the Domb-Sykes plot with the straight line and the intercept that follow
/// from the verdict (for a pair of singularities in the form of Mercer and Roberts), the root test, and the poles and
/// zeros of a Pade approximant (of order 80 at most) with the circle |t| = R. `found` is the radius_answer of the unknowns. Throws
/// input_error for complex coefficients and for series in powers of a root of the variable.
figure_content coefficient_plot(const std::vector<unknown_series>& unknowns, const answer& found,
                                const std::string& title, long digits);

}  // namespace libration
