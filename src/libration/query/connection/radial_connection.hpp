// Solutions of second-order equations with 1/t in them that tend to an equilibrium, such as radial ground states and vortices.
#pragma once

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// Whether the question is about u(inf) = L of u'' = sum c t^-p u^q u'^r with natural p, q, r, of which some p > 0, for one initial value as the
/// unknown.
bool is_radial(const connection_question& question);

/// That initial value: the solution is followed up to a time T from which on it is on the graph of saddle_graph.hpp. At t = 0, where the equation may have
/// the terms -k u'/t + l u/t^2, the solutions with u'(0) = 0 (l = 0), or u(0) = 0 (l = k), are t^n g, n = 0 or 1: in log t, (g, t g', t) leaves the line
/// of equilibria (x, 0, 0) along an unstable manifold (theorem W). Throws error like proved_connection.
connection proved_radial(const connection_question& question, const proof_route& route, const march_watch& watch);

}  // namespace libration::ode
