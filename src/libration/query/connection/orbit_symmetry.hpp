// Orbits with limits at both ends that a reversal of time maps to themselves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// y(t0 - t) = c + R (y(t0 + t) - c), R = diag(signs), for the solution through a state at t0 whose components with the sign -1 are those of c.
struct orbit_symmetry {
    std::vector<expression> of;      ///< the components of the state: unknowns and lower derivatives
    std::vector<int> signs;          ///< 1 or -1
    std::vector<expression> centre;  ///< c, constant; 0 for components with the sign 1
    number point;                    ///< t0

    /// c of a component with the sign -1: its value at t0.
    std::optional<expression> centre_of(const expression& component) const;
    /// "y(-t) = -y(t)", or "y(t) + y(-t) = y(-inf) + y(inf)" where c is nonzero.
    std::string text() const;
};

bool is_two_sided(const std::vector<limit_condition>& limits);
/// With initial values 0 where there are none; they have no effect where both ends are at infinity.
equation_system with_idle_starts(equation_system system);

/// The symmetry of an orbit with these limits at both ends, by exact arithmetic: an autonomous system has the reversal
/// S y = c + R (y - c), and each limit at -inf is the image under S of one at inf. The components with the sign 1 are
/// `unknowns`, initial values as y'(0); without them, those of the reversal that keeps components with equal limits and
/// has the fewest signs -1. std::nullopt if there is none, or more than 12 components. The initial values of the system
/// have no effect.
std::optional<orbit_symmetry> symmetry_between(const equation_system& system,
                                               const std::vector<limit_condition>& limits,
                                               const std::vector<std::string>& unknowns = {});

/// The symmetry of the solution of a question with limits at both ends, if its initial values are those of a symmetric one.
std::optional<orbit_symmetry> symmetry_of(const connection_question& question);

}  // namespace libration::ode
