// Zeros of a field, and neighborhoods of them in which all solutions approach the zero.
#pragma once

#include <optional>
#include <vector>

#include "reduced_field.hpp"

namespace libration::ode {

/// An enclosure of a zero of f near a point, by the Krawczyk operator: with A near the inverse of f_y(x) and a box X
/// around x, x - A f(x) + (1 - A f_y(X)) (X - x) in the interior of X proves one zero in X, in this set. Zeros in an
/// invariant subspace have its exact zeros. In the working precision; std::nullopt if none is proved.
std::optional<std::vector<ball>> enclosed_zero(const reduced_field& f, const std::vector<ball>& near);

/// The whole state at this zero, with exact zeros for all unknowns with which the right-hand sides vanish.
std::vector<ball> state_at_zero(const reduced_field& f, const std::vector<ball>& zero);

/// Whether every solution through one of these states approaches the zero, by theorem Q in one of the bases of
/// decay_basis.hpp.
bool is_approached(const reduced_field& f, const std::vector<ball>& zero, const std::vector<ball>& states);

}  // namespace libration::ode
