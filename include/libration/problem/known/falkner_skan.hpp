// The boundary layer of Falkner and Skan, whose condition is at infinity, proved by shooting from two sides.
#pragma once

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// s = f''(0) of f''' + f f'' + b (1 - f'^2) = 0, f(0) = f'(0) = 0, b > 0, with f' -> 1, near the given s, in the
/// working precision.
///
/// Lemma. Let f' > -1 on [0, T]. If f'(T) > 1 for one s (A), and f''(T) < 0 for another (B), then between them is an s
/// with f'' > 0, 0 < f' < 1 for all t > 0 and f' -> 1. Proof. Where |f'| < 1 and f'' = 0, f''' = -b (1 - f'^2) < 0: f''
/// crosses 0 downwards only; where f' > 1 upwards only. So in A f'' > 0 until f' = 1 for the first time, and there
/// (f'' = 0, f' = 1 is the solution f' = 1); in B f' never reached 1, otherwise f'' > 0 would persist. A and B, over
/// all T, are open and disjoint; an s in neither has f' < 1 and f'' >= 0 for all times, hence f'' > 0, and f' increases
/// to a limit L <= 1. L < 1 would imply f''' < -b (1 - L^2) for large t, and f'' negative [Coppel1960]. Uniqueness is
/// not claimed.
///
/// The middle is found by the secant method for f'(T) = 1 in floating-point arithmetic, T increasing; both sides are
/// integrated by theorem V. Throws precision_exhausted if neither side decides, error of the kind undecided if the
/// secant method does not converge from the initial guess.
ball falkner_skan_shear(const equation_system& given);

}  // namespace libration::ode
