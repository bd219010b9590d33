// The form of boundary-layer equations, whatever their names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/parametric_system.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// The places of f, f', f'' in the state, and the numbers of the equation, as expressions in the free numbers.
struct layer_text {
    parametric_system open;
    std::array<std::size_t, 3> places;
    expression a, limit;
    std::vector<expression> k;
};

/// The layer f''' = -a f f'' + (f' - L) k(f' - L) that a question is about: one condition f'(inf) = L. std::nullopt for
/// other questions, if a or L is not proved to be positive, or if a free number occurs in the equation.
std::optional<layer_text> layer_in(const connection_question& question);

/// The number of an expression without unknowns and parameters.
ball number_in(const expression& e);

}  // namespace libration::ode
