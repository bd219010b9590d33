// A condition on a solution as an additional unknown.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// A system with a further unknown w'' = (d/dt)^2 g(t, y(t)), w and w' at the initial point those of g and its
/// derivative, so that w(t) = g(t, y(t)): terms that cancel in g cancel in the coefficients of w, also over a wide set
/// of times, where g(t, Y) for the enclosure Y of the solution is much wider.
struct condition_system {
    explicit_system system;
    expression condition;             ///< w
    std::vector<std::size_t> places;  ///< indices of the given unknowns and their lower derivatives in its state
};

/// g in the unknowns of the system, their lower derivatives and its variable. Throws error for a singular initial
/// point.
condition_system with_condition(const explicit_system& system, const expression& g);

/// The value of each unknown or lower derivative that g = 0 determines by itself: that of a leaf in which g is linear,
/// without other leaves.
std::vector<std::optional<number>> given_values(const explicit_system& system, const expression& g);

}  // namespace libration::ode
