// Formulas of numbers as text.
#pragma once

#include <string_view>

#include "libration/number/exact_real.hpp"

namespace libration {

/// Reads a formula of numbers: decimals, pi, T (the period), numbers directly before pi, deg and T (150deg, 3T/4), + -
/// * / ^ (also **), parentheses, and exp log sqrt sin cos tan asin acos atan sinh cosh tanh. * and / associate to the
/// left, ^ binds tighter than a sign and associates to the right: -x^2 = -(x^2), 2^3^2 = 2^9, 2pi^2 = 2*pi^2; 1/2pi is
/// rejected as ambiguous. Blanks are allowed around signs and parentheses. Throws libration::error of kind argument
/// with the reason and the position, and as the operations of expression do. At most 100000 characters, nested at most
/// 100 deep.
exact_real read_expression(std::string_view text);

}  // namespace libration
