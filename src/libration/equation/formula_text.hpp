// The text of expressions, in the notation of problems.
#pragma once

#include <map>
#include <string>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// How tightly the outermost operation of a text binds.
enum class binding { sum, product, power, operand };

/// The text of an expression, which is put in brackets where an operation needs it.
struct formula_part {
    std::string text;
    binding by = binding::operand;

    std::string within(binding least) const { return by < least ? "(" + text + ")" : text; }
};

formula_part text_of_fraction(const rational& q);
/// A sum, product or quotient of operands with these texts.
formula_part text_of_arithmetic(const expression& e, const formula_part& left, const formula_part& right);
formula_part text_of_power(const formula_part& base, const formula_part& exponent);

/// The formula, with these names instead of those of its unknowns; constants other than fractions to 12 digits.
std::string formula_text(const expression& e, const std::string& variable,
                         const std::map<std::string, std::string>& names);

}  // namespace libration::ode
