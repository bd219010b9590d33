// Coefficient n of the series of groups of steps, in the widest vectors that the processor has.
#pragma once

#include <span>

#include "libration/ode/step_lanes.hpp"

namespace libration::ode {

/// Rows are padded so far behind each group.
inline constexpr std::size_t widest_vector = 8;

/// n > 0. Sums as sum_in_fours (placed_steps.hpp) does, each lane for itself.
void run_lanes(std::span<const lane_group> groups, lane_rows& rows, int n);

}  // namespace libration::ode
