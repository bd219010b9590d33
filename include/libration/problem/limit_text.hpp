// A problem with conditions at infinity in its text.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/limit_solution.hpp"

namespace libration {

/// The parameters without a value, and the unknowns and lower derivatives without an initial value, as f''(0), of a system whose initial
/// point is a fraction.
std::vector<std::string> open_numbers(const ode::equation_system& system);

/// The problem of a text with conditions at infinity, "f''' + f*f'' = 0; f(0)=0; f'(0)=0; f'(inf)=1". The unknowns have first guesses, "c = 0.3",
/// or none, "f''(0)"; without a list of them they are the open numbers. With conditions at both ends, initial values have no effect. Throws error of the
/// subject "problem" for a text that cannot be read or has no such condition, and of "unknowns" for a name that it does not have.
limit_problem limit_problem_of(const std::string& text, const std::vector<std::string>& unknowns = {});

/// The eigenvalue problem of a text "psi'' = (x^4 - E)*psi; psi(-inf) = 0; psi(inf) = 0" with the parameter E, for find_eigenvalues(): its
/// conditions at infinity, the others remain in the problem. Throws error of the subject "problem".
limit_problem eigenvalue_problem_of(const std::string& text, const std::string& energy);

}  // namespace libration
