// The limits of steps of Taylor series in a proof.
#pragma once

#include <algorithm>

namespace libration::ode {

/// log2 of the shortest step of a run with so many bits, relative to the time since the initial point: half of the bits,
/// between 40 and 160. Near a collision of two bodies at a distance d steps take about d^(3/2): they are followed as long
/// as the bits suffice. Before a singularity in real time, where steps become shorter without end, each bit costs five
/// steps.
constexpr long log2_of_least_step(long bits) { return -std::clamp(bits / 2, 40L, 160L); }

/// Steps of one integration, at most.
inline constexpr long most_series_steps = 10'000'000;

/// The errors that a step adds are this number of bits below the set: 2^16 steps add as much as its width.
inline constexpr long usual_bits_below_set = 20;

}  // namespace libration::ode
