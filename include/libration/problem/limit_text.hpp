// A problem with conditions at infinity in its text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/problem/limit_solution.hpp"

namespace libration {

/// The parameters without a value, and the unknowns and lower derivatives without an initial value, as f''(0), of a system whose initial
/// point is a fraction.
std::vector<std::string> open_numbers(const ode::equation_system& system);

/// The text without its conditions at infinity. With conditions at both ends it has further initial values: 0, without
/// effect; or, of an orbit that a reversal of time maps to itself (ode::symmetry_between), with these initial values as
/// unknowns or without a list of them, those that are known by it. Throws error of the subject "problem" for an initial
/// value that is typed and is not one of these.
std::string with_starts_between(const ode::separated_text& separated, const std::vector<std::string>& unknowns);

/// The orbit with these limits at both ends that a reversal of time maps to itself, with the initial values that it has
/// then instead of those of the problem (ode::symmetry_between); std::nullopt without such a reversal.
std::optional<limit_problem> symmetric_orbit_of(const problem& of, const std::vector<std::string>& limits);

/// The problem of a text with conditions at infinity, "f''' + f*f'' = 0; f(0)=0; f'(0)=0; f'(inf)=1". The unknowns have first guesses, "c = 0.3",
/// or none, "f''(0)"; without a list of them they are the open numbers. Throws error of the
/// subject "problem" for a text that cannot be read or has no such condition, and of "unknowns" for a name that it does not have.
limit_problem limit_problem_of(const std::string& text, const std::vector<std::string>& unknowns = {});

/// The eigenvalue problem of a text "psi'' = (x^4 - E)*psi; psi(-inf) = 0; psi(inf) = 0" with the parameter E, for find_eigenvalues(): its
/// conditions at infinity, the others remain in the problem. Throws error of the subject "problem".
limit_problem eigenvalue_problem_of(const std::string& text, const std::string& energy);

}  // namespace libration
