// Coefficient n of the series of groups of steps, using the widest SIMD vectors available.
#pragma once

#include <span>

#include "libration/expansion/step_lanes.hpp"

namespace libration::ode {

/// Rows are padded by this number after each group.
inline constexpr std::size_t widest_vector = 8;

/// n > 0. Sums like sum_in_fours (step_kernels.cpp), separately in each lane.
void run_lanes(std::span<const lane_group> groups, lane_rows& rows, int n);

}  // namespace libration::ode
