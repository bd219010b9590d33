// Boundary layers with a condition at infinity, proved by shooting from two sides: Falkner-Skan and Sakiadis; and what
// an SIR epidemic leaves.
#pragma once

#include "libration/ode/equation_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// s = f''(0) of f''' + f f'' + b (1 - f'^2) = 0, f(0) = f'(0) = 0, b > 0, with f' -> 1, near the given s, in the
/// working precision.
///
/// Lemma. Let f' > -1 on [0, T]. If f'(T) > 1 for one s (A), and f''(T) < 0 for another (B), then between them is an s
/// with f'' > 0, 0 < f' < 1 for all t > 0 and f' -> 1. Proof. Where |f'| < 1 and f'' = 0, f''' = -b (1 - f'^2) < 0: f''
/// crosses 0 downwards only; where f' > 1 upwards only. So in A f'' > 0 until f' = 1 for the first time, and there
/// (f'' = 0, f' = 1 is the solution f' = 1); in B f' never reached 1, or f'' > 0 would last. A and B, taken over all T,
/// are open and disjoint; an s in neither has f' < 1 and f'' >= 0 for all times, hence f'' > 0, and f' increases to a
/// limit L <= 1. L < 1 would make f''' < -b (1 - L^2) for large t, and f'' negative [Coppel1960]. Uniqueness is not
/// claimed.
///
/// The middle is found by the secant method for f'(T) = 1 in floating arithmetic, T growing; the sides are marched by
/// theorem V. Throws precision_exhausted where neither side decides, error of the kind undecided where the first guess
/// leads nowhere.
ball falkner_skan_shear(const equation_system& given);

/// G = f''(0) of 2 f''' + f f'' = 0, f(0) = 0, f'(0) = 1 with f' -> 0, likewise.
///
/// Lemma. If f'(T) < 0 for one G (A), and for another f > 0, f' > 2 |f''|/f at T (B), then between them is a G with f'
/// > 0 for all t and f' -> 0. Proof. f'' = G exp(-int f/2) < 0, so f' decreases. In B f'(t) >= f'(T) - 2 |f''(T)|/f(T)
/// > 0 from T on as long as f increases, which it then does for ever, and the limit of f' is positive. A and B are open
/// and disjoint; in neither f' stays >= 0, and its limit is not positive, for a positive one would give B at a large T.
ball sakiadis_shear(const equation_system& given);

/// What an SIR epidemic S' = -r S I, I' = r S I - a I leaves: S(inf) for S(0), I(0) > 0 and rho = a/r.
///
/// Lemma. S and S + I decrease and are positive, so S, I have limits; int a I dt <= S(0) + I(0), hence I(inf) = 0, and
/// S(inf) <= rho, for I would grow otherwise. S + I - rho log S is constant: S(inf) is the root in (0, rho) of S - rho
/// log S = S(0) + I(0) - rho log S(0), which is
///     -rho W_0(-(S(0)/rho) exp(-(S(0) + I(0))/rho))
/// with Lambert's function [Arb, arb_lambertw]. In the working precision.
ball epidemic_remainder(const ball& susceptible, const ball& infected, const ball& rho);

}  // namespace libration::ode
