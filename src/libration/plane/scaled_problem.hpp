// A problem in units in which its series about the start fits into the range of double.
#pragma once

#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// t = 2^time s and y_i = 2^sizes[i] u_i: the same problem in s and u_i, exactly.
struct scaled_problem {
    explicit_system system;
    long time = 0;
    std::vector<long> sizes;
};

/// Units from the radius of convergence about the initial point and the largest terms of the unknowns there; 0, and the
/// system itself, if these are within 2^+-6 and 2^+-32. The system must have initial values.
scaled_problem scaled_to_start(const explicit_system& of);

}  // namespace libration::ode
