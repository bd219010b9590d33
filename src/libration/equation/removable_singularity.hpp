// Quotients whose singularity is removable: u/(exp(u) - 1), sin(x)/x.
#pragma once

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// The expression with its removable singularities removed: where factors of a numerator and a divisor are functions of
/// one expression u, parameters replaced by their values, that are both exactly 0 at a number u0, both are divided by u -
/// u0, as often as necessary (function_of_one::difference). The result is the same function where the expression has a
/// value, and its continuous extension at u = u0; where the divisor has a zero of higher order, a pole remains. Two
/// summands with divisors that are both 0 at one u0, as coth(x) - 1/x, are read over one divisor, if that removes the
/// singularity.
///
/// u0 is searched among the numbers at which an argument of a function, or a base, in the two is 0, 1, -1, or a multiple
/// of pi/2 up to pi; that it is a zero is decided exactly. What is not recognised remains as it is.
expression with_removed_singularities(const expression& e);

}  // namespace libration::ode
