// Boundary layers f''' + a f f'' = q(f'), f'(inf) = L: f grows, so that the limit is not one at an equilibrium.
#pragma once

#include <optional>

#include "../../manifold/layer_graph.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// The layer equation that the question is about, whatever the names: one condition f'(inf) = L with L > 0 for an unknown of order 3
/// with f''' = -a f f'' + q(f'), a > 0, q a polynomial with q(L) = 0, all numbers. std::nullopt for other questions.
bool is_layer(const connection_question& question);

/// The value of the unknown for which f' tends to L exponentially, by theorems X and Y (manifold/layer_graph.hpp) and
/// Krawczyk's test for f'' = f (f' - L) Phi(1/f^2, f' - L) at a time T. If q' is positive at L, or q is 0, every solution with f' -> L
/// decays exponentially [THEOREMS, Y3]; otherwise the condition has to ask for that: throws error of the subject
/// "condition". Throws error like proved_connection.
connection proved_layer(const connection_question& question, const proof_route& route, const march_watch& watch);

}  // namespace libration::ode
