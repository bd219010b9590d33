// The number of zeros of a solution of a linear equation in a step.
#pragma once

#include <optional>

#include "../../manifold/linear_series.hpp"

namespace libration::ode {

/// The number of zeros for 0 < tau < 1, where the solution has this sign just after tau = 0: parts of the step in which the
/// solution has no zero, and parts in which it is monotonic, with its signs at their ends. std::nullopt if the precision, or the
/// number of parts, is too small.
std::optional<long> zeros_in_step(const linear_series& solution, int sign);

}  // namespace libration::ode
