// Denominators with roots as negative powers, for a polynomial form with fewer unknowns.
#pragma once

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The same equations with 1/r^3 for r = u^(1/2) written as u^(-3/2), a polynomial in u^(-1/2), whereas the quotient is a further unknown
/// of the polynomial form, whose right-hand side has a higher degree. Where one side is defined the other is, too: the power stays
/// one that is not whole.
expression with_negative_powers(const expression& e);

/// The system with these right-hand sides.
explicit_system with_negative_powers(const explicit_system& of);

}  // namespace libration::ode
