// Unknown parameters and initial values, proved by Krawczyk's test (algebra/krawczyk.hpp).
#pragma once

#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// The value of an unknown or a lower derivative at a time.
struct point_condition {
    std::string unknown;
    int derivative = 0;
    number time;
    number value;
};

/// Values of parameters, or initial values named as f''(0), that satisfy the same number of conditions, which may
/// contain them, also as times. The values in the system are the initial guess; the rows are in the order of the names.
/// Throws error like proved_root, for a name that is neither, and for conditions at no time. `watch` is the progress
/// callback of each integration.
std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const conditions_at_times& conditions, long digits,
                                            const proof_route& route = {}, const march_watch& watch = {});
/// The same for values at times.
std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits,
                                            const proof_route& route = {}, const march_watch& watch = {});

}  // namespace libration::ode
