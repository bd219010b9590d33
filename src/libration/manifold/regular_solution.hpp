// Solutions of linear equations of the second order at a regular singular point, with proved tails.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// below(w) (theta^2 - p theta) y = above(w) y with theta = w d/dw, p = 0 or 1, and polynomials, below(0) nonzero.
struct regular_equation {
    std::vector<ball> above, below;
    int p = 0;

    /// The larger root of rho^2 - p rho = above(0)/below(0); unbounded where it is not seen to be real.
    ball exponent() const;
};

/// y/w^rho and (theta y)/w^rho for one w.
struct regular_value {
    ball value, slope;
    bool is_positive;  ///< y/w^rho > 0 is seen from 0 to w
};

/// y = w^rho (1 + sum c_k w^k) for the larger exponent rho > 0 and exact w > 0. With A = sum |below_i w^i/below_0|,
/// C = sum |above_i w^i/below_0|, i >= 1, the recurrence
///     (k^2 + (2 rho - p) k) below_0 c_k = sum (above_i - below_i (r^2 - p r)) c_(k-i),  r = rho + k - i,
/// gives |c_k w^k| <= q max of the last `degree` of them for k > N >= 1, q = (A (rho + N)^2 + C)/(N^2 + (2 rho - p) N), and
/// where q < 1 the tails of second_order_step. To the working precision, or with N = terms if terms > 0. std::nullopt if q < 1 is
/// not seen: for smaller w it is.
std::optional<regular_value> regular_solution_at(const regular_equation& of, const ball& w, std::size_t terms = 0);

}  // namespace libration::ode
