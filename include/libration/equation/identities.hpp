// Identities between expressions, by exact arithmetic.
#pragma once

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// Whether an expression is 0 for all values of its leaves for which it is defined: all coefficients of it as a
/// polynomial in leaves, and in those subexpressions that are not polynomials, are exactly 0. False if that does not
/// show it, which proves nothing.
bool is_identically_zero(const expression& e);

/// Whether e is 0 wherever u is: e is identically 0, a constant multiple of u, or identically 0 after a leaf in which u
/// is linear, with a constant coefficient, is replaced by its value for u = 0. Where e is continuously differentiable,
/// |e| is then at most a constant times |u|. False if that does not show it.
bool vanishes_with(const expression& e, const expression& u);

}  // namespace libration::ode
