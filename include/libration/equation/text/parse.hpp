// Parser of differential equations.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Maximum number of characters of a problem.
inline constexpr std::size_t longest_problem = 1'000'000;
/// Maximum number of characters of a name in it, including its primes.
inline constexpr std::size_t longest_name = 200;

/// Parses
///     f''' + f*f''/2 = 0                     equations
///     f(0) = 0; f'(0) = 0, f''(0) = k        initial values, all at one point
///     k = 1                                  parameters, in any order, may contain parameters
///     r = k*f                                names for expressions in unknowns and the variable
///     0 = f^2 + g^2 - 1                      algebraic equations
///     variable x                             the independent variable
///     f'(t) = -f(t - tau)                    a constant delay, positive: of unknowns and lower derivatives
///     f(t <= 0) = 1 + t                      the history of a delayed unknown, which gives its initial values too
///     invariant E - cos(y)                   constant along a solution
///     exact f = tan(t)                       a closed form
///     q[i]' = p[i] for i = 1..9              a statement for each value of an index
///     # a comment
/// Statements end with ; or the end of the line, or a comma outside parentheses. Names: a letter, then letters, digits,
/// _; case-sensitive. Reserved are pi, inf, the variable and the names of functions in function/list.hpp. An unknown with
/// the name of another column of tables, n, time, digits, rigour, time_typed or count, is n_ in the system and in its
/// columns (renamed_unknowns.hpp). e is Euler's number unless it is an unknown, a parameter or the variable. Numbers are
/// exact: 2E-3 is 0.002. Operators + - * / ^ (also **): * and / are left-associative; ^ binds tighter than a sign and is
/// right-associative; x^y with an exponent that is not constant is exp(y*log(x)), for x > 0; primes bind to their name.
/// Functions exp log sqrt sin cos tan asin acos atan sinh cosh tanh and the others of function/list.hpp, and those that
/// are read as formulas of these: cot, atan2, mod, max, .. (docs/equations.md). At most longest_problem characters;
/// parentheses, signs and exponents nest at most 100 deep.
///
/// Conditions, in if(x > 0, a, b), piecewise(a, x > 0, b) and `when`: comparisons < <= > >= == != and chains of them,
/// 0 <= x < 1, combined by `not` or !, `and` or &&, `or` or ||, in descending order of precedence. An equality at single
/// moments does not count.
///
/// Derivatives: x', x'(t), dx/dt for the first, x'', x''(t), d2x/dt2, d^2x/dt^2 for the second; x(t) is x. The
/// independent variable is that of `variable`; else t of dx/dt; else x of y'(x) or y(x); else x, if no unknown is
/// called x and t does not occur; else t.
///
/// Products: a number multiplies a name or a parenthesis directly after it, with or without a blank: 2y, 2 y, 2(y + 1),
/// 3 sin(t), where 2e3 is a number. 1/2y and x^2y are rejected as ambiguous, as are a(t + 1) and f(0) in a formula. pi
/// and deg after a number are units, 150deg.
///
/// UTF-8: Greek letters are read as their names (theta), x² and x⁻¹ for powers, y₁ for y1, ′ and ″ for primes, · × ÷ −
/// for operators, π ∞ ° √ for pi, inf, deg, sqrt.
///
/// Other names without a definition are parameters whose values are open (equation_system::open): changed() sets them,
/// and initial values that are missing; a system with open parameters has no solution. Throws error with the line, the
/// column in characters, and the remedy.
equation_system parse(std::string_view text);

/// The same problem in standard notation, which parse() reads as the same system: a statement in each line, in ASCII,
/// with primes for derivatives, * for each product and the variable, if it is not t, or if another one would be
/// inferred. Throws error like parse().
std::string canonical_text(std::string_view text);

/// The system with parameters and initial values that are changed, or that were open, as `k = 1/3` or `f''(0) = 0.332,
/// k = 2`. Throws error like parse(), and for a name that does not occur in the system.
equation_system changed(equation_system system, std::string_view text);

/// The system with a name for an expression in unknowns or time, as r of r = k*x*y, as one more unknown, or in `shown` if
/// the system has events or step functions. Throws error for any other name.
equation_system with_column(equation_system system, const std::string& name);

/// left - right of a condition such as x' = 1/2 on the unknowns of a system, their lower derivatives and the variable,
/// with its parameters replaced by their values. Throws error like parse().
expression parse_condition(const equation_system& of, std::string_view text);

/// Adds a condition such as y(1) + y'(1) = 0, y(0) = y(1) or y(T)^2 = k: an equation between expressions of parameters
/// and of unknowns of the system or lower derivatives, each at a constant time. Throws error like parse(), with the
/// condition as it would be accepted.
void add_condition(conditions_at_times& to, const equation_system& of, std::string_view text);

/// The unknown of the system or lower derivative, and the constant time, of a text such as x'(0); its value is 0. Throws
/// error like parse().
start parse_value_at_time(const equation_system& of, std::string_view text);

/// A constant expression, as for a time or the value of a parameter: numbers, pi, functions, a number directly before
/// pi or deg. Throws error like parse().
expression parse_constant(std::string_view text);

/// The same with i, the imaginary unit: 1+2i, (1+i)/2, -i*pi/3. Throws error if i is not a summand or a factor.
complex_constant parse_complex_constant(std::string_view text);

}  // namespace libration::ode
