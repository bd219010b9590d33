// The tritronquee solution of the first Painleve equation, whose condition is at infinity.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// A solution of second order at a point.
struct value_and_slope {
    ball value, slope;
};

/// The tritronquee solution: that of u'' = 6 u^2 + z that is real on the real axis and has the expansion
///     u ~ -sqrt(x/6) sum_k b_k eta^k,  x = -z, eta = x^(-5/2)/sqrt(6), b_0 = 1,
///     2 b_m = -sum_(0<i<m) b_i b_(m-i) - (25 (m-1)^2 - 1)/4 b_(m-1)
/// for |arg x| < 4 pi/5 [Boutroux1913; JoshiKitaev2001].
///
/// Lemma. With w(x) = u(z), w'' = 6 w^2 - x. Let p be the expansion up to b_N,
///     6 p^2 - x - p'' = E,  |E| <= C x^(1 - 5(N+1)/2) for x >= X,
/// and r = w - p: r'' + q r = 6 r^2 + E, q = -12 p > 0. With a = q^(1/4), f = a r, g = r'/a and h^2 = f^2 + g^2,
///     f' = (a'/a) f + a^2 g,  g' = -a^2 f - (a'/a) g + (6 r^2 + E)/a,  |h'| <= |a'/a| h + 6 h^2/a^3 + |E|/a.
/// For x >= X let |a'/a| <= kappa/x, 1/a <= A x^(-1/8). With s = 5(N+1)/2 - 15/8 > 5/8, where
///     s H > kappa H + 6 A^3 X^(5/8) H^2 + C A X^(-s),
/// exactly one solution has h <= H (x/X)^(-s) from X on, and it is the one with the expansion. Proof. H (x/X)^(-s)
/// decreases faster than the bound of |h'| there, at X and hence beyond: the solution with r = r' = 0 at some L > X
/// remains below it back to X, since h cannot meet it from below. Of those for L -> inf a subsequence converges at X
/// with its slope, and by continuity on every interval: its limit remains below too. For the difference d of two such
/// solutions, d'' + q d = 6 (r_1 + r_2) d, likewise |h_d'| <= (kappa/x + 12 A^3 H X^s x^(-s-3/8)) h_d, so that h_d at X
/// is at most a constant times L^kappa h_d(L) = O(L^(kappa - s)), which tends to 0. A solution with the expansion,
/// which holds for its derivative as well, has h = O(x^(5/8 - 5(N+1)/2)), less than that for large x.
///
/// w(X) and w'(X) from the terms up to b_N, N the smaller of `most` >= 1 and the index from which on terms do not
/// decrease any more or are below the working precision. Throws precision_exhausted if the inequality is not certain.
value_and_slope tritronquee_far_out(int x, int most);

/// u(0) and u'(0) in the working precision: from an X where the terms are below it, theorem V integrates back to x = 0.
/// Throws precision_exhausted if that does not succeed.
value_and_slope tritronquee_start();

}  // namespace libration::ode
