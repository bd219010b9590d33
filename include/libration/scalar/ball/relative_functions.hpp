// The functions exprel and cosrel on balls, with the coefficients of their series about a ball.
#pragma once

#include <vector>

#include "libration/scalar/ball/value.hpp"
#include "libration/scalar/relative_kind.hpp"

#if __has_include(<flint/acb.h>)
#include <flint/acb.h>
#else
#include <acb.h>
#endif

namespace libration {

/// Coefficients 0 .. count - 1 of the series of exprel(n, x) or cosrel(n, x) about every point of a ball, n >= 1.
///
/// F_j(x) = (1/j!) d^j/dx^j exprel(n, x) = n!/(n + j)! M(j + 1, n + j + 1, x) [DLMF 13.3.16], for which the equation of
/// Kummer's function M gives F_j = x (j + 2) F_(j+2) + (j + n + 1 - x) F_(j+1). About a ball with the midpoint m and the
/// radius r, F_j is the value at m up to r (j + 1) |F_(j+1)|, |F_j(x)| <= exp(max(Re x, 0)) n!/(n + j)!
/// (function/elementary/exprel.hpp). cosrel(n, x) = (exprel(n, i x) + exprel(n, -i x))/2. Cost: 2 hypergeometric series
/// and O(count) products.
std::vector<ball> relative_series(relative_kind kind, int n, const ball& x, int count);

/// The value alone; the order is a ball that is a whole number.
void relative_ball(arb_struct* y, relative_kind kind, const arb_struct* order, const arb_struct* x, long bits);
void relative_ball(acb_struct* y, relative_kind kind, const acb_struct* order, const acb_struct* x, long bits);

}  // namespace libration
