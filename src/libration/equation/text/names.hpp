// The names of a problem: its independent variable, unknowns and parameters, found before formulas are read.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "statement.hpp"

namespace libration::ode {

/// The meanings of the names of a problem.
struct known_names {
    std::string variable = "t";
    std::set<std::string, std::less<>> unknowns;
    std::set<std::string, std::less<>> parameters;
};

/// The names of a system, with the parameters that it leaves open.
known_names names_of(const equation_system& system);

/// Whether the name is that of a function.
bool is_function_name(std::string_view name);

/// Throws error for pi, inf, the variable and names of functions.
void require_free_name(const token& name, const std::string& variable);

/// The independent variable, declared by `variable x`; std::nullopt if it is not declared. Throws error for more than
/// one declaration.
std::optional<std::string> declared_variable(const std::vector<statement>& all);

/// Replaces dx/dt, d2x/dt2 and d^2x/dt^2 by x' and x'', unless dx or dt is a name of the statements or a known one. The
/// variable is a letter, a Greek letter, one of these with a number, or `variable`; of dt2, the number is an order.
/// Returns the variable of the first one; std::nullopt if there is none. Throws error for another variable, an unknown
/// in its place, and for orders that are not the same.
std::optional<std::string> with_primes(std::vector<statement>& all, const std::optional<std::string>& variable,
                                       const known_names& known = {});

/// The variable, unless it is known: x in y'(x) = ... or in y(x), if y is an unknown; x, if no unknown is called x and
/// t does not occur; else t. Throws error if several names are possible.
std::string inferred_variable(const std::vector<statement>& all);

/// The names that have primes, and those of statements name = ...: unknowns and parameters. Throws error for reserved
/// names.
known_names names_in(const std::vector<statement>& all, const std::string& variable);

/// The other names that are not reserved, at their first occurrence: parameters whose value is open.
std::vector<open_parameter> open_names(const std::vector<statement>& all, const known_names& known);

/// Where there are more equations than unknowns, moves unknowns without a derivative from the names that are open: all
/// if these are as many as are missing, otherwise those with an initial value.
void add_algebraic_unknowns(const std::vector<statement>& all, known_names& names, std::vector<open_parameter>& open);

/// For each unknown that has the name of a column of tables (n, time, digits, rigour, time_typed, count) a name that the
/// text does not use, with _ behind it, by which the system and its columns name it.
std::map<std::string, std::string> renamed_columns(const std::vector<statement>& all, const known_names& names);
/// The same for the names of a system, in texts that refer to it.
std::map<std::string, std::string> renamed_columns(const known_names& names);
/// Replaces names in the tokens; messages quote the text as it is typed.
void rename(statement& words, const std::map<std::string, std::string>& names);

/// k = ...: the definition of a parameter, which is a name without primes and not an unknown.
bool is_definition(const statement& words, const known_names& names);

/// name(...) = ..., an initial value; not y'(x) = ..., where x is the variable.
bool is_start(const statement& words, const std::string& variable);

/// name(t <= ...) = ..., a history, with any name for t; also with < instead of <=.
bool is_history(const statement& words);

/// Whether the tokens after the name of this index are the variable in parentheses: y'(x).
bool has_variable_behind(const statement& words, std::size_t name, const std::string& variable);

}  // namespace libration::ode
