// The radius of convergence of a linear equation, and the kinds of the nearest singularities, by the law of all coefficients.
#pragma once

#include <optional>
#include <string>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// proved_radius for an equation with polynomial coefficients (ode::linear_equation) one of whose singular points is proved to be the
/// nearest singularity of the solution: the others at that distance or below have no solution with a singularity (ode::fuchsian_point).
/// std::nullopt for other problems and where this is not proved.
std::optional<answer> radius_by_linear_law(const ode::explicit_system& system, const request& how);

/// The kinds of the singularities of one equation at the least distance, in words, if its law is proved; otherwise "".
std::string kinds_by_law(const ode::explicit_system& system, const request& how);

}  // namespace libration
