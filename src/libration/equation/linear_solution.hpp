// Solves equations that are linear in the highest derivatives for these.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Whether a coefficient is nonzero at the initial point, so that division by it is possible.
using nonzero_test = std::function<bool(const expression&)>;

/// An equation from which elimination removes all targets: remainder = 0.
struct constraint {
    std::size_t equation = 0;  ///< its index
    expression remainder;
};

/// An expression by which the row of a target was divided.
struct divisor {
    std::size_t target = 0;  ///< its index
    expression by;
};

/// targets[i] = values[i], free of the targets; or, if elimination removes all targets from an equation, these
/// constraints and no values.
struct linear_result {
    std::vector<expression> values;
    std::vector<constraint> constraints;
    std::vector<divisor> divisors;     ///< all that are not numbers
    std::vector<expression> doubtful;  ///< those for which the test is false
};

/// Throws error if an equation is not linear in the targets, or if the equations do not determine them for another
/// reason than constraints.
linear_result linear_solution(const std::vector<equation>& equations, const std::vector<expression>& targets,
                              const nonzero_test& may_divide);

}  // namespace libration::ode
