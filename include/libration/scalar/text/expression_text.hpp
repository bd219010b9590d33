// Formulas of numbers as text.
#pragma once

#include <string_view>

#include "libration/scalar/expression.hpp"

namespace libration {

/// Reads a formula of numbers: decimals, pi, T (the period), numbers directly before pi, deg and T (150deg, 3T/4),
/// + - * / ^ (also **), parentheses, and exp log sqrt sin cos tan asin acos atan sinh cosh tanh. * and / go from left
/// to right, ^ binds tighter than a sign and to the right: -x^2 = -(x^2), 2^3^2 = 2^9, 2pi^2 = 2*pi^2; 1/2pi is refused
/// as ambiguous. Blanks may stand around signs and parentheses. Throws libration::error of kind argument saying what is
/// wrong with the text and where, and as the operations of expression do. At most 100000 characters, nested at most 100
/// deep.
expression read_expression(std::string_view text);

}  // namespace libration
