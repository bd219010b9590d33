// The run from a part of a box by the integrator that encloses it well, and how well that is.
#pragma once

#include <cstddef>
#include <vector>

#include "set_query.hpp"

namespace libration::ode {

/// By theorem V; if that ends early, or if values that are not monotone are not close to linear on the part, by Taylor
/// models, as far as these reach; and over spans of time from a wide part, for which they take less time, if they are
/// close. Where both are complete their bounds at times hold together. Its steps are those of all runs.
set_run_result best_run(const set_query& question, const number_box& part, bool with_derivatives);

/// Below this share of the range of the whole box an excess is not worth a division.
inline constexpr double negligible_excess = 1.0 / 16;

/// How much wider the enclosure of a value on a part is than its linear image or, by Taylor models, than its range may
/// be, relative to a range.
double excess_of(const set_image& image, std::size_t value, const number_box& part, const closed_interval& range);

/// Whether a value is monotone in a number of the box, by its derivatives on the whole of it: 1 and -1 for increasing
/// and decreasing ones, 2 for one that is constant, 0 if the sign is not decided.
int direction_of(const ball& derivative);
bool is_monotone(const std::vector<ball>& derivatives);

}  // namespace libration::ode
