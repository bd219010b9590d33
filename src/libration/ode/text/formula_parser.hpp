// Parser of formulas in the tokens of a statement.
#pragma once

#include <set>
#include <string>

#include "libration/ode/expression.hpp"
#include "statement.hpp"

namespace libration::ode {

/// The meanings of the names of a problem.
struct known_names {
    std::string variable = "t";
    std::set<std::string, std::less<>> unknowns;
    std::set<std::string, std::less<>> parameters;
};

/// Whether the name is that of a function.
bool is_function_name(std::string_view name);

/// Throws error for pi, inf, the variable and names of functions.
void require_free_name(const token& name, const std::string& variable);

/// The same for an unknown, which is the name of a column of tables: n, time, digits and rigour are names of other
/// columns.
void require_free_column(const token& name, const std::string& variable);

/// In equations products need *; values also allow 3pi/4 and 150deg, points 2i, where i is a parameter.
enum class formula_role { equation, value, point };

/// The formula in the tokens first .. last - 1, at least one. Throws error with the position and the remedy.
expression read_formula(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                        formula_role role);

}  // namespace libration::ode
