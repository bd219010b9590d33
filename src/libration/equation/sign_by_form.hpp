// Signs of expressions that their form alone shows.
#pragma once

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// 1 or -1 if the expression is positive or negative wherever it is defined, for all real values of its leaves, as
/// exp(-t/5), 1 + x^2 and 2 + sin(t); 0 if this is not shown: by the signs of constants and of exp, cosh, roots and even
/// powers, the bounds 1 of |sin|, |cos|, |tanh| and |erf|, and sums, products and quotients of these.
int sign_by_form(const expression& e);

}  // namespace libration::ode
