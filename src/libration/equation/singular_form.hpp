// Right-hand sides with factors (t - t0)^r about an initial point t0.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "start_values.hpp"

namespace libration::ode {

/// The scaled right-hand sides of y_i^(q_i) = right[i] about the point; std::nullopt if they contain no power of t -
/// t0. Throws error if the initial point is irregular singular.
std::optional<singular_start> singular_form(const std::vector<unknown_function>& unknowns,
                                            const std::vector<expression>& right, const number& point,
                                            start_values& values);

/// Whether e = (t - t0)^r g about the point t0 with g nonzero at the initial values, so that e vanishes at most there.
/// Returns false if it cannot be decided.
bool has_isolated_zero(const expression& e, const number& point, start_values& values);

}  // namespace libration::ode
