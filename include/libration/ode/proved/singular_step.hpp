// The first step away from a regular singular start, enclosed.
#pragma once

#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// The solution of a system with a singular start a little after it, where its right sides have values.
struct singular_step {
    explicit_system beyond;        ///< the system of first order, at a point behind the start
    std::vector<ball> state;       ///< the unknowns and their lower derivatives there, in order
    std::vector<ball> on_the_way;  ///< enclosures of all that they are between the start and there
};

/// By theorem S (tail_bound.hpp) with a remainder below 2^-bits of the unknowns. Throws error where the series is not in
/// whole powers of the distance, where the right sides are no polynomials in the unknowns and their first derivatives;
/// precision_exhausted where no radius is proved.
singular_step proved_singular_step(const explicit_system& system, long bits);

}  // namespace libration::ode
