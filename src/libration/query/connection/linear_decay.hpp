// Solutions of linear equations of order 2 in the time that tend to 0 at infinity.
#pragma once

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// Whether the question is about y(inf) = 0, or y(-inf) = 0, of one linear equation of order 2, without a further term, in which the time occurs,
/// for one initial value as the unknown.
bool is_linear_decay(const connection_question& question);

/// The initial value for which y tends to 0, of y'' + p y' = q y with p and q rational in t, or in exp(r t), about fractions.
///
/// For psi = y exp(integral of p/2), psi'' = V psi with V = q + p^2/4 + p'/2. If V > 0 beyond some time, with a limit V(inf) > 0 or
/// inf, exactly one solution psi up to a factor tends to 0, exponentially, with psi'/psi <= -sqrt(inf V), and psi'/psi is enclosed at the initial
/// point (well_side.hpp). With it y -> 0 if p >= 0 beyond some time, or if p -> 0. If also q >= 0 beyond some time, all other solutions do
/// not tend to 0 [docs/theorems/infinity.md, linear equations]. Throws error of the kind undecided where one of these conditions does
/// not hold, naming it, and if the value is not distinguished from 0.
connection proved_linear_decay(const connection_question& question, const march_watch& watch);

}  // namespace libration::ode
