// Heat and other quantities that are carried by a boundary layer, at infinity.
#pragma once

#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// Whether the question is about a boundary layer f (layer_connection.hpp) with f'(inf) = L and quantities g'' = -c f g', c > 0 a
/// number, with limits g(inf).
bool is_carried(const connection_question& question);

/// The unknown of the layer, by proved_layer(), and one of g(0), g'(0) for each of the quantities. With the solution J for which J(0) = 0,
/// J'(0) = 1,
///     g(inf) = g(0) + g'(0) J(inf),   J(inf) = J(T) + J'(T) int_0^inf exp(-c int_T^(T+x) f) dx.
/// From the time on from which theorem Y holds, |f' - L| does not increase: with d = |f'(T) - L| the integral is between the two of
/// exp(-c (f(T) x + (L +- d) x^2/2)), which are sqrt(pi/(2 c l)) exp(z^2) erfc(z), z = f(T) sqrt(c/(2 l)), l = L +- d. Throws error like proved_layer, and
/// of the subject "unknowns" for other ones.
connection proved_carried(const connection_question& question, const proof_route& route, const march_watch& watch);

}  // namespace libration::ode
