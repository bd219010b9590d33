// States at times in any order, from enclosed initial values.
#pragma once

#include <optional>
#include <vector>

#include "libration/integration/proof_route.hpp"
#include "libration/integration/proved_march.hpp"

namespace libration::ode {

/// The given unknowns at times on both sides of the initial point, by one integration in each direction, with so many bits.
/// std::nullopt if one of them is not reached.
std::optional<std::vector<std::vector<ball>>> marched_states(const explicit_system& system,
                                                             const std::vector<ball>& start,
                                                             const std::vector<ball>& times, long bits,
                                                             const proof_route& route, const march_watch& watch = {});

}  // namespace libration::ode
