// Formulas in the words of a statement.
#pragma once

#include <set>
#include <string>

#include "libration/ode/expression.hpp"
#include "statement.hpp"

namespace libration::ode {

/// What the names of a problem mean.
struct known_names {
    std::string variable = "t";
    std::set<std::string, std::less<>> unknowns;
    std::set<std::string, std::less<>> parameters;
};

/// Whether the name is one of a function.
bool is_function_name(std::string_view name);

/// Throws error for pi, inf, the variable and names of functions.
void require_free_name(const token& name, const std::string& variable);

/// The same for an unknown, which names a column of tables: n, time, digits and rigour are those of others.
void require_free_column(const token& name, const std::string& variable);

/// Equations multiply with * alone; values also read 3pi/4 and 150deg, points 2i, where i is a parameter.
enum class formula_role { equation, value, point };

/// The formula in the words first .. last - 1, at least one. Throws error with the place and the remedy.
expression read_formula(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                        formula_role role);

}  // namespace libration::ode
