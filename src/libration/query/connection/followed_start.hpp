// Solutions of a system with free numbers at a time, with their derivatives by these numbers.
#pragma once

#include <optional>
#include <vector>

#include "connection_map.hpp"

namespace libration::ode {

/// The typed initial values for enclosed free numbers.
start_values typed_start(const parametric_system& open, const std::vector<ball>& numbers);

/// The state `time` after the initial point from this start. std::nullopt if more bits are needed.
std::optional<start_values> followed_start(const parametric_system& open, const start_values& from, double time,
                                           long bits, long error_bits, const march_watch& watch,
                                           const proof_route& route);

}  // namespace libration::ode
