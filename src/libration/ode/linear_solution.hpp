// Solves equations that are linear in the highest derivatives for these.
#pragma once

#include <functional>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// Whether a coefficient is nonzero at the initial point, so that division by it is possible.
using nonzero_test = std::function<bool(const expression&)>;

/// targets[i] = result[i], free of the targets. Throws error if an equation is not linear in them, or if the equations
/// do not determine them.
std::vector<expression> linear_solution(const std::vector<equation>& equations, const std::vector<expression>& targets,
                                        const nonzero_test& may_divide);

}  // namespace libration::ode
