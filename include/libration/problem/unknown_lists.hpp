// The Taylor coefficients of every unknown of a system as lists for tests of convergence.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/series_request.hpp"

namespace libration {

/// a_0 .. a_order about a time, by default the initial point, each correct to this number of digits
/// (ode::rounded_coefficients, which also defines the errors).
std::vector<unknown_series> unknown_lists(const ode::explicit_system& system, long order, long digits,
                                          const std::optional<ode::complex_constant>& at = {});

}  // namespace libration
