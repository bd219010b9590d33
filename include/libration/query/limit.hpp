// The limit of a solution that approaches a stable equilibrium, with every digit proved.
#pragma once

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives, in order, at infinite time, as the only state, by theorem Q: `digits`
/// significant digits each, proved to one unit in the last; or a bound of a value that is not distinguished from 0,
/// which is then the reason for a missing decimal. y' = f(y) is
/// integrated (proved_march) up to the times 2^k after the initial point until its state is within a neighborhood of a
/// zero y* of f, enclosed by the Krawczyk operator, in which all solutions approach y*. Unknowns that are determined by
/// the others through sums c.y with rational c and c.f = 0 are eliminated before, as f_y would be singular. The zeros
/// of an invariant subspace are exact. Systems that do not influence each other are treated separately.
///
/// Throws error of the kind undecided, of the subject "time", if the right-hand sides contain t or the initial point is
/// singular, and if no such neighborhood is reached: equilibria that are approached like a power of t are not found.
partial_trajectory limit_at_equilibrium(const explicit_system& system, long digits, const march_watch& watch = {},
                                        const proof_route& route = {});

}  // namespace libration::ode
