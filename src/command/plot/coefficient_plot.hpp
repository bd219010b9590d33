// The figure of `libration radius --plot`: the plots of coefficients by which the nearest singularity is found.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/series_request.hpp"
#include "plot/figure_file.hpp"

namespace libration {

/// For each of the unknowns, four at most, the Domb-Sykes plot (for a pair of singularities in the form of Mercer and
/// Roberts) with the line, intercept and exponent of the verdict, or of its own test if the verdict has no exponent; the root test;
/// the poles and zeros of a Pade approximant, of order 80 at most, with the circle |t| = R of the verdict; and, as far as
/// the verdict has them, its convergence with the number of coefficients, the positions and exponents of the differential
/// approximants that agree, and the digits to which coefficients are predicted. `found` is the radius_answer of the
/// unknowns. Throws input_error for complex coefficients and for series in powers of a root of
/// the variable.
figure_content coefficient_plot(const std::vector<unknown_series>& unknowns, const answer& found,
                                const std::string& title, long digits);

}  // namespace libration
