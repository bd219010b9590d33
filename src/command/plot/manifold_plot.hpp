// The figure of `libration trajectory --manifold --plot`.
#pragma once

#include <string>

#include "libration/query/connection/equilibrium_manifolds.hpp"
#include "plot/figure_file.hpp"

namespace libration {

/// The branches in the plane of two quantities, with arrows in the direction of time, and the equilibrium. Throws input_error for names
/// that are not quantities.
figure_content manifold_plot(const ode::equilibrium_manifolds& of, const std::string& x, const std::string& y,
                             const std::string& problem);

}  // namespace libration
