// Right-hand sides with factors (t - t0)^r about an initial point t0, and the consistency of the initial values there.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/tape.hpp"
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

/// Throws error if the given coefficients do not satisfy the equations, or if unknowns have fractional powers below a
/// derivative that the equations use. Decided by the exact signs of numbers, not by tolerances; also throws error if such
/// a sign is not decided.
void require_consistent_start(const tape& made, const explicit_system& of);

}  // namespace libration::ode
