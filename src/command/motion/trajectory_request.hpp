// The request of `libration trajectory`.
#pragma once

#include <vector>

#include "motion/motion_options.hpp"
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

}  // namespace libration
