// The solution of any differential equation at a list of times as a table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "complex_times.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/problem/limit_solution.hpp"
#include "libration/problem/solution.hpp"
#include "option/options.hpp"
#include "problem_options.hpp"
#include "solution_table.hpp"
#include "text/table.hpp"

namespace libration {

/// The argument of --times for a problem: exact numbers without a unit. Throws input_error.
std::vector<exact> times_of_problem(const std::string& words);

/// The same as constants of equations.
std::vector<ode::number> constants_of(const std::vector<exact>& times);

/// time,<unknown and its lower derivatives>...,digits,rigour,time_typed.
std::vector<column> columns_of_states(const ode::explicit_system& system);

/// Throws input_error for times of which `missing` states that they are not reached.
[[noreturn]] void refuse_times(const error& missing);

/// The states of a solution (states_table): in mpfr each value correct to one unit in its last digit, by a closed form
/// or by two integrations that differ in order and in precision (two-method), in fixed scalars as one integration
/// computes it (heuristic), in balls each digit proved. Throws input_error if no time is reached in arithmetic that
/// rounds; otherwise a time that is not reached is missing.
partial_table problem_trajectory(const solution& of, const std::vector<exact>& times, const arithmetic& numbers,
                                 const std::function<void(double)>& progress = {},
                                 ode::integrator_choice integrator = ode::integrator_choice::automatic);

/// time_re,time_im,<unknown and its lower derivatives>_re,.._im,...,digits,rigour,time_typed: the same at points of the
/// complex t-plane (solution::states_along). Throws input_error for a point that is not reached, and for balls, which
/// cannot prove such a path.
table problem_trajectory_along(const solution& of, const std::vector<ode::complex_constant>& corners,
                               const std::vector<typed_point>& times, const arithmetic& numbers);

/// How a trajectory of a problem is computed from the coefficients about its initial point.
struct chosen_approximation {
    std::string method;  ///< series, pade, endpoint, euler, gauge, asymptotic or rk4
    int order;           ///< N, last power; without meaning for rk4
    exact step = {};     ///< of rk4
    /// Of euler and gauge; the radius of convergence by the verdict on each unknown's coefficients unless given.
    std::optional<exact> scale = std::nullopt;
};

/// time,<unknown>...,digits,rigour,time_typed,<unknown>_error...: the approximations of the unknowns from the
/// coefficients a_0 .. a_N about the initial point, and their distance from the solution, which is integrated
/// (problem_trajectory). `series` is the partial sum, `pade` the diagonal approximant in the powers that do not vanish
/// by symmetry, `endpoint` also matches value and slope of the solution at the farthest time, `euler` is the partial sum
/// in s/(s + scale), s = t - t0, or in the same function of the powers that do not vanish by symmetry, `gauge` the one in
/// 1 - exp(-s/scale), `asymptotic` has the asymptotic behaviour of a problem of the catalogue if it is known, and that unknown alone. In mpfr the values are
/// correct to one unit in their last digit (two-method); an error has the digits that the values support, and is empty
/// if they support none, a value if there is no such approximant. Throws input_error for balls, for asymptotic
/// approximants of other problems or in a fixed scalar, for endpoint, euler and gauge with times on both sides of the
/// initial point, without a scale that the coefficients show, and for times that are not reached.
table problem_approximation(const problem_options& problem, const chosen_approximation& by,
                            const std::vector<exact>& times, const arithmetic& numbers);

/// The same table of asymptotic approximants by behaviour_at_infinity().
table limit_approximation(const limit_problem& of, int order, const std::vector<exact>& times,
                          const arithmetic& numbers);

}  // namespace libration
