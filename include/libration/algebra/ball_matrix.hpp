// Matrices of balls: enclosures of real matrices, entry by entry.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// Rows of a square matrix.
using ball_matrix = std::vector<std::vector<ball>>;

/// The midpoint, rounded to the working precision, as an exact ball.
ball exact_midpoint(const ball& x);

/// a b.
ball_matrix product(const ball_matrix& a, const ball_matrix& b);

/// An approximate inverse of the midpoint: exact numbers, not an enclosure; std::nullopt if it is singular.
std::optional<ball_matrix> inverse_near(const ball_matrix& a);

}  // namespace libration::ode
