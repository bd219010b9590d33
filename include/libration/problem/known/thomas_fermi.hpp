// The Thomas-Fermi equation of the neutral atom, whose condition is at infinity.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// The slope y'(0) of y'' = y^(3/2)/sqrt(t), y(0) = 1, with y -> 0, in the working precision [Boyd2013].
///
/// With s = sqrt(t) and v = dy/dt the equation is dy/ds = 2 s v, dv/ds = 2 y^(3/2), which is regular at 0.
///
/// Lemma. (A) If y > 0 up to s and v(s) >= 0 for one slope, and (B) 4 y^(5/2) < s v^2, v < 0 at some s for another,
/// then between them is a slope with y > 0 and v < 0 for all times and y -> 0, and no other. Proof. dv/ds >= 0, so with
/// v, y remains positive in A from there on and does not decrease. In B let d = -v/(4 y^(3/2)), y and v at s: as long
/// as v < 0, y decreases, hence dv/ds <= 2 y(s)^(3/2) and v <= v(s)/2 up to s + d, where y would be at most y(s) + s
/// v(s) d < 0: y reaches 0. The difference of two solutions has (y2 - y1)'' > 0 while it is positive: a larger slope
/// keeps y and v larger, so all slopes of A are above all of B; both sets are open. A slope in neither has y > 0, v < 0
/// for all times, and y decreases to a limit, which is 0, since for a positive one v would grow beyond 0. The
/// difference of two such solutions would grow, while both decrease to 0.
///
/// The slope is found by bisection in floating-point arithmetic; both sides are integrated by theorem V. Throws
/// precision_exhausted if one of them does not decide.
ball thomas_fermi_slope();

}  // namespace libration::ode
