// A trajectory by the exact solution or by a partial sum, with proved digits.
#pragma once

#include <string>
#include <vector>

#include "motion/trajectory_request.hpp"

namespace libration {

/// One time. Each digit of theta and omega is that of the method's own exact value, not of its rounding; the error is
/// |theta as printed - the exact solution|.
struct proved_point {
    std::string theta;
    std::string omega;
    std::string error;
};

/// All times, digits as request.numbers asks. Throws std::invalid_argument for rk4, which has no proof, and
/// std::runtime_error where the precision ends before the digits are proved.
std::vector<proved_point> proved_trajectory(const trajectory_request& request);

}  // namespace libration
