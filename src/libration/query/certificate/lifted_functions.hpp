// Functions of a solution as polynomials in the unknowns of a polynomial form.
#pragma once

#include <vector>

#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// A polynomial form in which functions of the given unknowns and the variable are polynomials too, with these and
/// their derivatives along the solution.
struct lifted_functions {
    polynomial_form form;
    std::vector<expression> functions, slopes;
};

/// Functions in the unknowns of the system, their lower derivatives and its variable. Throws error like lifted().
lifted_functions lifted_with(const explicit_system& of, const std::vector<expression>& functions);

}  // namespace libration::ode
