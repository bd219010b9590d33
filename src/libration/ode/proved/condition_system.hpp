// A condition on a solution as an unknown beside it.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// A system with a further unknown w'' = (d/dt)^2 g(t, y(t)), w and w' at the start those of g and its derivative, so
/// that w(t) = g(t, y(t)): what cancels in g cancels in the coefficients of w, also over a wide set of times, where
/// g(t, Y) for the enclosure Y of the solution is much wider.
struct condition_system {
    explicit_system system;
    expression condition;             ///< w
    std::vector<std::size_t> places;  ///< of the unknowns of the given system and their lower derivatives in its state
};

/// g in the unknowns of the system, their lower derivatives and its variable. Throws error for a singular start.
condition_system with_condition(const explicit_system& system, const expression& g);

}  // namespace libration::ode
