// Right sides with factors (t - t0)^r about a start t0.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "start_values.hpp"

namespace libration::ode {

/// The scaled right sides of y_i^(q_i) = right[i] about the point; nothing where no power of t - t0 stands in them.
/// Throws error where the start is irregular.
std::optional<singular_start> singular_form(const std::vector<unknown_function>& unknowns,
                                            const std::vector<expression>& right, const number& point,
                                            start_values& values);

}  // namespace libration::ode
