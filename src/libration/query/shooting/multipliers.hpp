// Floquet multipliers of a periodic orbit, enclosed.
#pragma once

#include <optional>
#include <vector>

#include "known_directions.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::ode {

/// The multipliers that are exactly 1 left out: enclosures that contain one eigenvalue each, if they are distinguished, or
/// clusters; std::nullopt if M is too wide.
struct enclosed_multipliers {
    std::vector<complex_number<ball>> values;
    bool isolated = false;
};
std::optional<enclosed_multipliers> other_multipliers(const ball_matrix& flow, const known_directions::at_state& known);

/// What the multipliers prove about stability.
orbit_stability stability_of(const enclosed_multipliers& others, std::size_t ones, bool symplectic);

}  // namespace libration::ode
