// The highest derivatives out of equations that are linear in them.
#pragma once

#include <functional>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// Whether a coefficient may be divided by at the start.
using nonzero_test = std::function<bool(const expression&)>;

/// targets[i] = result[i], free of the targets. Throws error where an equation is not linear in them, or where they do
/// not come out of the equations.
std::vector<expression> linear_solution(const std::vector<equation>& equations, const std::vector<expression>& targets,
                                        const nonzero_test& may_divide);

}  // namespace libration::ode
