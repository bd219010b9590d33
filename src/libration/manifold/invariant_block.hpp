// A basis of the invariant subspace of a group of eigenvalues, in balls.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "complex_jet.hpp"

namespace libration::ode {

struct invariant_block {
    jet_matrix columns;  ///< V by rows, the unit matrix in the pivot rows
    jet_matrix inner;    ///< M with A V = V M
};

/// Encloses V and M, with their derivatives, for all matrices A of the balls, also complex ones: Krawczyk's test for the
/// rows outside of the pivots of A V - V (A V)_pivots = 0, in complex balls. Its zero is regular iff the group has no
/// eigenvalue in common with the others, whatever the eigenvalues inside of it are: multiple ones, and Jordan blocks.
/// `near` is V by columns. std::nullopt if the test fails.
std::optional<invariant_block> enclosed_block(const jet_matrix& a, const std::vector<std::size_t>& pivots,
                                              const std::vector<std::vector<complex_jet>>& near);

}  // namespace libration::ode
