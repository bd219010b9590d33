// The two-body problem in the plane: equations that are recognised as its, on an elliptic orbit.
#pragma once

#include <array>
#include <optional>

#include "libration/equation/explicit_system.hpp"

namespace libration {

/// x'' = -m x/(x^2 + y^2)^(3/2), y'' = -m y/(x^2 + y^2)^(3/2), m > 0 a number, on an orbit that is proved to be elliptic:
/// of negative energy and nonzero angular momentum.
struct recognised_kepler {
    ode::number attraction;               ///< m
    std::array<ode::number, 2> position;  ///< at the initial time, in the order of the unknowns
    std::array<ode::number, 2> velocity;
};

/// For any names, order of the equations, initial time and notation of the power of the distance: a right-hand side is
/// compared as a product of powers of a number, the unknown and x^2 + y^2. std::nullopt for other equations, and for
/// orbits of which no precision shows that they are elliptic.
std::optional<recognised_kepler> recognise_kepler(const ode::explicit_system& system);

}  // namespace libration
