// Hybrid systems with the derivatives of their state with respect to numbers as further unknowns.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "libration/equation/hybrid_system.hpp"

namespace libration::ode {

/// What depends on a number p: unknowns at some time, and initial values.
struct dependence_on_number {
    /// p itself: an initial value as the leaf that has it, or the parameter.
    expression leaf;
    std::set<std::string> unknowns;
    /// Of each of the leaves in varied_system, constant or in terms of `leaf`.
    std::vector<expression> starts;

    /// Whether an expression in the state does.
    bool has(const expression& e) const;
};

/// y' = f with u' = f_y u + f_p for each number p, on each branch; those numbers that are parameters are constant
/// unknowns. The derivatives of unknowns that do not depend on p are left out.
struct varied_system {
    hybrid_system system;
    std::vector<expression> leaves;                 ///< the state of the problem, and the parameters
    std::vector<std::size_t> own;                   ///< the indices of the state of the problem in that of the system
    std::vector<dependence_on_number> dependences;  ///< on each number, in order; system.variations() likewise
};

/// For parameters and initial values by their names, r and x'(0). Throws error as hybrid_system, and of the subject
/// "derivatives" for numbers that the problem does not have and that must be constant.
varied_system system_with_variations(const equation_system& given, const std::vector<std::string>& numbers);

}  // namespace libration::ode
