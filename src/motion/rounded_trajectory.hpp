// A trajectory by any method in a rounding scalar, beside the truth.
#pragma once

#include <vector>

#include "libration/scalar/mpfr.hpp"
#include "motion/trajectory_request.hpp"

namespace libration {

/// theta, omega (in the motion's units) and the true theta at each time.
struct trajectory_values {
    std::vector<mpfr> motion;
    std::vector<mpfr> truth;
};

/// All times, in the scalar of request.numbers; in mpfr with as many guard digits as it takes for two runs to agree,
/// but for rk4. The truth is the exact solution, of which another route judges method exact. Throws input_error for
/// what the scalar cannot hold.
trajectory_values rounded_trajectory(const trajectory_request& request);

}  // namespace libration
