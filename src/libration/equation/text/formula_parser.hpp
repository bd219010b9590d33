// Parser of formulas in the tokens of a statement.
#pragma once

#include <cstddef>

#include "libration/equation/equation_system.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

/// The most parentheses, signs and exponents around a part of a formula.
inline constexpr int deepest_formula = 100;

/// Numbers before pi and deg are units in every role; points also allow 2i, where i is a parameter, and in values T is
/// rejected as the period of a motion.
enum class formula_role { equation, value, point };

/// The formula in the tokens first .. last - 1, at least one. With `values`, unknowns are at a constant time, y'(1),
/// which is added to them and represented by its leaf. With `into`, piecewise functions and delayed unknowns, x(t - 1),
/// are supported, which are added to its step functions and delays. Throws error with the position and the remedy.
expression read_formula(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                        formula_role role, conditions_at_times* values = nullptr, equation_system* into = nullptr);

/// The sum that begins with the token `next`, which then is the one behind it, in an equation.
expression read_sum(const statement& words, std::size_t& next, std::size_t last, const known_names& names,
                    equation_system* into);

}  // namespace libration::ode
