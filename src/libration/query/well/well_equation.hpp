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
    bool mirrored = false;        ///< V is typed with abs(x) or other signs of x, and is V(-x) for x < 0

    /// The same equation in -x, for x of one sign if V is mirrored.
    well_equation reflected() const;
    bool is_even() const;
};

/// d^2 y/dx^2 + p(s) dy/dx = q(s) y with s = x, or s = exp(r x).
struct damped_equation {
    std::string unknown;
    rational_function damping;    ///< p
    rational_function restoring;  ///< q
    bool exponential = false;     ///< s = exp(r x)
    rational rate = 1;            ///< r > 0

    /// The same equation in -x, and in x - c; the latter only for s = x.
    damped_equation reflected() const;
    damped_equation shifted(const rational& c) const;
    /// psi'' = V psi with V = q + p^2/4 + (dp/dx)/2 for psi = y exp(integral of p/2), as a well with E = 0.
    well_equation without_damping() const;
};

/// Whether the equations are one linear equation of order 2, without a further term, in which the variable occurs.
bool is_linear_in_time(const equation_system& system);

/// The equation in which `energy` is the number E. Throws error of the subject "problem" that names the term for which it has
/// not this form. With functions of the sign of x, V is that for x > 0, and has to be even.
well_equation read_well(const equation_system& system, const std::string& energy);

/// The equation, without another parameter. Throws error like read_well().
damped_equation read_damped(const equation_system& system);

}  // namespace libration::ode
