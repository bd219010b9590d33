// Initial values of systems with algebraic equations.
#pragma once

#include <vector>

#include "index_reduction.hpp"
#include "libration/equation/explicit_system.hpp"
#include "start_values.hpp"

namespace libration::ode {

/// Computes the missing initial values, empty lists in `starts`, from the algebraic equations; false if none is missing.
/// Throws error if the equations are not linear in them or do not determine them.
bool complete_starts(const std::vector<unknown_function>& unknowns, const number& point,
                     const std::vector<algebraic_equation>& algebraic, std::vector<std::vector<number>>& starts);

/// Throws error unless every algebraic equation is proved to hold at the initial point.
void require_consistent(const std::vector<algebraic_equation>& algebraic, start_values& values);

}  // namespace libration::ode
