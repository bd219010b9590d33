// Differential equations as text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// The most characters of a problem.
inline constexpr std::size_t longest_problem = 1'000'000;
/// The most characters of a name in it, with its primes.
inline constexpr std::size_t longest_name = 200;

/// Reads
///     f''' + f*f''/2 = 0                     equations
///     f(0) = 0; f'(0) = 0; f''(0) = k        starts, all at one point
///     k = 1                                  parameters, in any order, parameters in them too
///     variable x                             the independent variable, t otherwise
///     invariant E - cos(y)                   what stays constant along a solution
///     exact f = tan(t)                       a closed form
///     # a comment
/// Statements end with ; or a line. Names: a letter, then letters, digits, _; case counts. Reserved are pi, inf, the
/// variable and the names of functions; for unknowns also n, time, digits, rigour, other columns of tables. Numbers are
/// exact: 2E-3 is 0.002. Operators + - * / ^ (also **): * and / from left to right; ^ binds tighter than a sign and to
/// the right, and its exponent is constant; primes bind to their name. Functions exp log sqrt sin cos tan asin acos
/// atan sinh cosh tanh. In values (of starts and parameters) a number may stand directly before pi and deg.
/// At most longest_problem characters; parentheses, signs and exponents nest at most 100 deep. Throws error with the
/// line, the column and the remedy.
equation_system parse(std::string_view text);

/// The system with one parameter or start changed, as `k = 1/3` or `f''(0) = 0.332`. Throws error as parse(), and for
/// what the system does not have.
equation_system changed(equation_system system, std::string_view text);

/// left - right of a condition such as x' = 1/2 on the unknowns of a system, their lower derivatives and the variable,
/// its parameters replaced by their values. Throws error as parse().
expression parse_condition(const equation_system& of, std::string_view text);

/// A condition f'(5) = 1: an unknown of the system or a lower derivative, at a constant time, a constant value. Throws
/// error as parse().
start parse_point_condition(const equation_system& of, std::string_view text);

/// A constant expression, as a time or the value of a parameter: numbers, pi, functions, a number directly before pi or
/// deg. Throws error as parse().
expression parse_constant(std::string_view text);

/// The same with i, the imaginary unit: 1+2i, (1+i)/2, -i*pi/3. Throws error where i is not a summand or a factor.
complex_constant parse_complex_constant(std::string_view text);

}  // namespace libration::ode
