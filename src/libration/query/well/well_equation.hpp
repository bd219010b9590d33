// Linear equations psi'' = (V(x) - c E) psi as typed, with a rational potential V, or one that is rational in exp(r x).
#pragma once

#include <string>

#include "libration/equation/equation_system.hpp"
#include "rational_function.hpp"

namespace libration::ode {

/// d^2 psi/dx^2 = (V(s) - c E) psi with s = x, or s = exp(r x).
struct well_equation {
    std::string unknown;
    rational_function potential;  ///< V
    rational weight = 1;          ///< c > 0
    bool exponential = false;     ///< s = exp(r x)
    rational rate = 1;            ///< r > 0

    /// The same equation in -x.
    well_equation reflected() const;
    bool is_even() const;
};

/// Whether the equations have the form of a well: one linear equation of order 2, whose coefficients contain no other
/// unknown, with the variable in it.
bool is_linear_of_second_order(const equation_system& system);

/// The equation in which `energy` is the number E. Throws error of the subject "problem" that names the term for which it has
/// not this form.
well_equation read_well(const equation_system& system, const std::string& energy);

}  // namespace libration::ode
