// The periods T and T* of a motion as a table.
#pragma once

#include <optional>

#include "libration/pendulum/period.hpp"
#include "motion_options.hpp"
#include "option/options.hpp"
#include "text/table.hpp"

namespace libration {

/// How a period is computed.
struct period_request {
    chosen_motion chosen;
    arithmetic numbers;
    pendulum::period_method method;
    std::optional<int> order = {};  ///< of a partial sum
};

/// energy,gap,method,order,period,tstar,error,regime and the numbers as typed: T, T* and |T* as printed - true value| in
/// the motion's units, to the digits of the request; inf at E = 2.
table period_table(const period_request& request);

}  // namespace libration
