// The constant C of theorems A and B: an upper bound of the mean of |y| over |t - t0| = rho.
#pragma once

#include <functional>

#include "libration/plane/charted_covering.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// A bound of |y| over a ball of offsets in tip k, on both sides of its slit; infinite if there is none.
using tip_bound = std::function<magnitude(std::size_t k, const complex_ball& offset)>;

/// By arcs, each of a cell on the circle, halved until their bounds are within a fifth of the lower ones; for a real system, from the
/// upper half plane alone. Throws error of the kind undecided with the place where |y| is not bounded: a singularity on the circle.
magnitude circle_mean(const charted_covering& covering, double rho, const tip_bound& of_tip);

}  // namespace libration::ode
