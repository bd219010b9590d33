// Solutions of a system with free numbers at a time, with their derivatives by these numbers.
#pragma once

#include <optional>
#include <vector>

#include "connection_map.hpp"

namespace libration::ode {

/// The typed initial values for enclosed free numbers.
differentiable_start typed_start(const parametric_system& open, const std::vector<ball>& numbers);

/// The state `time` after the initial point from this start. std::nullopt if more bits are needed.
std::optional<differentiable_start> followed_start(const parametric_system& open, const differentiable_start& from,
                                                   double time, long bits, long error_bits, const march_watch& watch,
                                                   const proof_route& route);

}  // namespace libration::ode
