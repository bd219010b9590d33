// Eigenvalues of psi'' = (V(x) - c E) psi on a line, a half-line or an interval, with their indices.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// Which eigenvalues are requested.
struct eigenvalue_question {
    equation_system system;               ///< its values at points are the conditions there, up to a factor
    std::string energy;                   ///< the parameter E
    std::vector<limit_condition> limits;  ///< psi(inf) = 0, psi(-inf) = 0
    long count = 1;                       ///< the first ones, or
    std::optional<double> near = {};      ///< the one nearest to this
    long digits = 50;
};

/// An eigenvalue and its index: the number of zeros of its eigenfunction between the ends.
struct eigenvalue {
    long index;
    known_value value;
};

/// The eigenvalues in increasing order, and why some are missing.
struct eigenvalues {
    std::vector<eigenvalue> values;
    std::string proved;  ///< a sentence
    std::optional<error> missing = {};
};

/// The first eigenvalues of psi'' = (V - c E) psi, c > 0, with psi -> 0 at an infinite end, or a value, a slope or a
/// ratio of both at a point, where V is a rational function of x, or of exp(r x), without poles between the ends, and E
/// is below the continuous spectrum.
///
/// Each solution that satisfies the condition of one end is computed up to a point m, with the number of its zeros. The
/// number of eigenvalues below E is the number of all these zeros, plus 1 if psi'/psi of the left one is less than that
/// of the right one at m [Weidmann1987, 14; docs/theorems/infinity.md, wells]: so the eigenvalue of index n is the only one between
/// two E with n and n + 1 eigenvalues below them, and a change of the sign of the Wronskian there gives its digits. Even
/// wells are halved by the conditions psi'(0) = 0 and psi(0) = 0. Cost: about digits^2 operations.
///
/// Throws error of the subject "problem" for other equations, naming the term, and of the subject "conditions" for other
/// conditions.
eigenvalues proved_eigenvalues(const eigenvalue_question& question, const march_watch& watch = {});

/// Whether a connection is the question about a well: one unknown parameter E of a linear equation of order 2 in which
/// the variable occurs.
bool is_well(const equation_system& system, const std::vector<std::string>& unknowns);

}  // namespace libration::ode
