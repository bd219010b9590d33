// Bases in which the decay towards an equilibrium is seen in every component. No proof depends on how they are found.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "../algebra/dense_matrix.hpp"

namespace libration::ode {

/// Columns in blocks of 1 or 2.
struct block_basis {
    dense_matrix columns;
    std::vector<std::size_t> blocks;
};

/// The eigenvectors of a matrix, the real and the imaginary part of complex ones in one block; std::nullopt unless all
/// eigenvalues have a negative real part.
std::optional<block_basis> basis_of_eigenvectors(const dense_matrix& of);

/// For a matrix with nearly parallel eigenvectors, as of critical damping: its real Schur vectors in double [Eigen],
/// scaled such that the entries outside the blocks of the triangular form are small compared with the slowest decay;
/// std::nullopt unless all eigenvalues have a negative real part.
std::optional<block_basis> scaled_schur_basis(const dense_matrix& of);

}  // namespace libration::ode
