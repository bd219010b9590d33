// Unknown parameters and initial values of a problem, and its periodic orbits, each proved to exist.
#pragma once

#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"

namespace libration {

/// The parameters or initial values k, f''(0) for which as many conditions f'(5) = 1 hold, near the values that the
/// problem has, each digit proved: name and value, a row for each. A condition is an equation between expressions of
/// parameters and of values at several times, f(0) + f'(1)^2 = k (ode::add_condition). Conditions at infinity, f'(inf) = 1, are
/// decided by a lemma about a problem of the catalogue (proved_for_infinity), otherwise by ode::proved_connection, with
/// the notes "proved" and "not claimed"; unknowns in `without_guess` have no first guess there. With request.check the
/// values are compared with a second proof: throws std::runtime_error with both enclosures if they disagree. Of the
/// callbacks only request.reached is called, which may throw to end the search: what it throws reaches the caller.
/// Throws error of the subjects "conditions" for conditions, "condition" for one at infinity, "unknowns" for unknowns
/// that it cannot determine.
answer find_unknowns(const problem& of, const std::vector<std::string>& unknowns,
                     const std::vector<std::string>& conditions, const request& how,
                     const std::vector<std::string>& without_guess = {});

/// The first eigenvalues E, `count` of them, of psi'' = (V - c E) psi with conditions at two ends, of which psi(inf) = 0 and psi(-inf) = 0 are `limits`
/// (ode::proved_eigenvalues): name and value, a row E_n for each, n the number of zeros of the eigenfunction, and the notes
/// "proved" and, for a value that is not distinguished from 0, its bound. answer::missing is set if there are fewer below the continuous
/// spectrum. With request.check and callbacks as above.
answer find_eigenvalues(const problem& of, const std::string& energy, const std::vector<std::string>& limits,
                        long count, const request& how);
/// The conditions at infinity of an orbit from an equilibrium to itself, for find_unknowns(): x(-inf) = v and x(inf) = v, v the
/// equilibrium near the initial values, in fractions. Throws error of the subject "problem" if none is found.
std::vector<std::string> homoclinic_conditions(const problem& of);

/// The values of a parameter or an initial value along which a branch is followed, as typed, at least two in one
/// direction.
struct branch_values {
    std::string parameter;
    std::vector<std::string> values;
};

/// The branch of solutions of the conditions in a parameter, past turning points (ode::follow_branch), from the first
/// value and the problem's first guess: a row for each passage of one of the values and for each turning point, in the
/// order of the branch: point ("solution" or "turning point"), the parameter, and the unknowns, each digit proved, or
/// with a bound below 10^-digits for a value that is not distinguished from 0. The note "end" is where and why the
/// branch ends; answer::missing is set if points are not proved, if the branch could not be continued, or if a callback
/// threw an error of the kind undecided after the first point: request.reached, or request.progress, which is called
/// with 0 after each point. With request.check as above, point by
/// point. Throws error like find_unknowns, and of the subject "along" for the parameter and its values.
answer find_branch(const problem& of, const std::vector<std::string>& unknowns,
                   const std::vector<std::string>& conditions, const branch_values& along, const request& how);

/// A question about a periodic orbit.
struct orbit_options {
    std::string period;        ///< as typed; empty: not given
    bool multipliers = false;  ///< also the Floquet multipliers
};

/// A period as typed, in numbers and parameters of the problem. Throws error unless that is a positive number.
ode::number typed_period(const ode::equation_system& of, const std::string& typed);

/// The periodic orbit near the initial values of an autonomous problem: the unknowns and their lower derivatives,
/// and `period`; name and value, a row for each, each digit proved, compared and watched as above. With multipliers rows
/// "multiplier 1", or "multiplier 1, real part" and "multiplier 1, imaginary part"; those that are exactly 1 first, the others in
/// descending absolute value. For an orbit of a family the notes are what keeps its given value, by which integrals, and
/// whether a shorter time is a period; with multipliers, why some are 1, and the stability. Throws error like
/// ode::proved_periodic_orbit, and for a period that is not a positive number.
answer find_periodic_orbit(const problem& of, const request& how, const orbit_options& options = {});

}  // namespace libration
