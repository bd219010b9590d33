// The asymptotic behaviour that conditions at infinity prove: required by asymptotic approximants.
#pragma once

#include "libration/problem/far_behaviour.hpp"
#include "libration/problem/limit_solution.hpp"

namespace libration {

/// Of the first unknown with a condition y(inf) = L, or else y'(inf) = L, from the initial point on:
/// far_form::exponential with the limit of y and the slowest rate of decay of theorem W (limit_solution::unknowns);
/// for a boundary layer with y'(inf) = L, far_form::power with the line L t + B, where y - L t is B to 10^-digits at
/// `end`, by an integration; for a linear equation in the time, which decays faster than every power, the same with the
/// line 0; for a decay like t^-m far_form::algebraic, from the initial point on. At any working precision. Each digit is
/// heuristic, since the approximant is not bounded. Throws error of the subject "problem" for orbits with two ends, for
/// limits without such a rate, as of radial problems, and where two rates are the slowest, as those of an oscillation.
far_behaviour behaviour_at_infinity(const limit_problem& of, long digits);

}  // namespace libration
