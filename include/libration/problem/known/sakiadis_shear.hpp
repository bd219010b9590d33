// The boundary layer of Sakiadis, whose condition is at infinity, proved by shooting from two sides.
#pragma once

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// G = f''(0) of 2 f''' + f f'' = 0, f(0) = 0, f'(0) = 1 with f' -> 0, near the given G, in the working precision:
/// found and proved as falkner_skan_shear(), with the same errors.
///
/// Lemma. If f'(T) < 0 for one G (A), and for another f > 0, f' > 2 |f''|/f at T (B), then between them is a G with f'
/// > 0 for all t and f' -> 0. Proof. f'' = G exp(-int f/2) < 0, so f' decreases. In B f'(t) >= f'(T) - 2 |f''(T)|/f(T)
/// > 0 from T on as long as f increases, which it then does forever, and the limit of f' is positive. A and B are open
/// and disjoint; in neither f' remains >= 0, and its limit is not positive, since a positive one would imply B at a
/// large T.
ball sakiadis_shear(const equation_system& given);

}  // namespace libration::ode
