// A table of the solution of any differential equation at times.
#pragma once

#include <memory>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/solution.hpp"
#include "table/motion_table.hpp"

namespace libration {

/// The equation of a table.
struct table_problem {
    ode::explicit_system system;
    std::unique_ptr<const libration::solution> solution;
};

/// time,<unknown and its lower derivatives>..., and in the typed style digits,rigour,time_typed. In the style for
/// programs derivative j of x is x_dj. Each digit is proved. Throws input_error for a time that is not reached.
table problem_table(const table_problem& of, const std::vector<exact>& times, long digits, input_style style);

}  // namespace libration
