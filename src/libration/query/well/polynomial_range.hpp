// Polynomials with ball coefficients, and their signs and ranges on half-lines.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// Coefficients by increasing powers.
using ball_polynomial = std::vector<ball>;

ball_polynomial times(const ball_polynomial& a, const ball_polynomial& b);
/// a + factor b.
ball_polynomial added(ball_polynomial a, long factor, const ball_polynomial& b);
ball_polynomial slope_of(const ball_polynomial& p);
ball value_at(const ball_polynomial& p, const ball& s);
/// Whether p(s) >= 0 for all s >= from is seen by the coefficients of p(from + t), and p(s) > 0.
bool is_nonnegative_from(const ball_polynomial& p, const ball& from);
bool is_positive_from(const ball_polynomial& p, const ball& from);
/// p(s)/s^n for all s >= from > 0, n at least the degree.
ball range_from(const ball_polynomial& p, std::size_t n, const ball& from);

}  // namespace libration::ode
