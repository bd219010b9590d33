// Systems of differential and algebraic equations as differential equations: equations from which the highest
// derivatives can be eliminated are differentiated until the others determine all of them.
// Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II (1996), section VII.1: the differentiation
// index.
#pragma once

#include <vector>

#include "linear_solution.hpp"

namespace libration::ode {

/// An expression in the variable, unknowns and lower derivatives that is 0 along every solution.
struct algebraic_equation {
    expression zero;
    place at = {};
};

/// target[i] = right[i], to which the equations are equivalent where the algebraic equations hold at the initial point.
struct reduced_system {
    std::vector<expression> right;
    std::vector<divisor> divisors;              ///< all that are not numbers
    std::vector<expression> doubtful;           ///< the divisors that are not proved nonzero at the initial point
    std::vector<algebraic_equation> algebraic;  ///< those given, and the derivatives of these that are algebraic again
};

/// Solves the equations for the highest derivatives, which they contain linearly. Throws error as linear_solution()
/// does; and for algebraic equations that contain no unknowns, or whose derivatives are algebraic more often than there
/// are unknowns and lower derivatives.
reduced_system reduced(std::vector<equation> equations, const std::vector<expression>& highest,
                       const nonzero_test& may_divide);

}  // namespace libration::ode
