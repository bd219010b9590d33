// Parser of differential equations.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// Maximum number of characters of a problem.
inline constexpr std::size_t longest_problem = 1'000'000;
/// Maximum number of characters of a name in it, including its primes.
inline constexpr std::size_t longest_name = 200;

/// Parses
///     f''' + f*f''/2 = 0                     equations
///     f(0) = 0; f'(0) = 0; f''(0) = k        initial values, all at one point
///     k = 1                                  parameters, in any order, may contain parameters
///     variable x                             the independent variable, by default t
///     invariant E - cos(y)                   constant along a solution
///     exact f = tan(t)                       a closed form
///     # a comment
/// Statements end with ; or the end of the line. Names: a letter, then letters, digits, _; case-sensitive. Reserved are
/// pi, inf, the variable and the names of functions; for unknowns also n, time, digits, rigour, other columns of
/// tables. Numbers are exact: 2E-3 is 0.002. Operators + - * / ^ (also **): * and / are left-associative; ^ binds
/// tighter than a sign, is right-associative, and its exponent is constant; primes bind to their name. Functions exp
/// log sqrt sin cos tan asin acos atan sinh cosh tanh. In values (initial values and values of parameters) a number may
/// directly precede pi and deg. At most longest_problem characters; parentheses, signs and exponents nest at most 100
/// deep. Throws error with the line, the column and the remedy.
equation_system parse(std::string_view text);

/// The system with one parameter or initial value changed, as `k = 1/3` or `f''(0) = 0.332`. Throws error like parse(),
/// and for a name that does not occur in the system.
equation_system changed(equation_system system, std::string_view text);

/// left - right of a condition such as x' = 1/2 on the unknowns of a system, their lower derivatives and the variable,
/// with its parameters replaced by their values. Throws error like parse().
expression parse_condition(const equation_system& of, std::string_view text);

/// A condition f'(5) = 1: the constant value of an unknown of the system or a lower derivative at a constant time.
/// Throws error like parse().
start parse_point_condition(const equation_system& of, std::string_view text);

/// A constant expression, as for a time or the value of a parameter: numbers, pi, functions, a number directly before
/// pi or deg. Throws error like parse().
expression parse_constant(std::string_view text);

/// The same with i, the imaginary unit: 1+2i, (1+i)/2, -i*pi/3. Throws error if i is not a summand or a factor.
complex_constant parse_complex_constant(std::string_view text);

}  // namespace libration::ode
