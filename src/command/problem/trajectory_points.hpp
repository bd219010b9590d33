// A trajectory by any method in any arithmetic, with the error of each angle.
#pragma once

#include <string>
#include <vector>

#include "motion_options.hpp"
#include "option/options.hpp"

namespace libration {

enum class trajectory_method { exact, series, resummed, uniform, rk4 };

struct trajectory_request {
    chosen_motion chosen;
    arithmetic numbers;
    trajectory_method method;
    int order;   ///< of a partial sum
    exact step;  ///< of rk4
    std::vector<exact> times;
    int jobs = 1;  ///< threads
};

/// One time as it is printed. If the digits are correct or proved, they are those of the method's own exact value, not
/// of its rounding; the error is |theta as printed - the exact solution|.
struct trajectory_point {
    std::string theta;
    std::string omega;  ///< in the motion's units
    std::string error;
    std::string undecided;  ///< the reason if there are no digits
};

/// All times, on request.jobs threads, in the scalar of request.numbers: as a fixed scalar computes them, proved in
/// balls, and correct in mpfr, also by enclosures, which give the digits in one run (rk4 is one run of mpfr). Every
/// method is compared with proved enclosures. A time whose digits no precision within the limits decides has no
/// numbers, but the reason. Throws input_error for values that the scalar cannot represent, std::logic_error for rk4 in
/// balls, which cannot be proved.
std::vector<trajectory_point> trajectory_points(const trajectory_request& request);

}  // namespace libration
