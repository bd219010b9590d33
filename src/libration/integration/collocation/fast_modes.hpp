// The directions of a linear flow that decay within a step, and the others, which are followed along it.
#pragma once

#include <optional>
#include <vector>

#include "../../algebra/dense_matrix.hpp"

namespace libration::ode {

/// Columns as vectors.
using ball_columns = std::vector<std::vector<ball>>;

/// A basis of the space for a matrix J: its fast eigenvectors, the real and the imaginary part of a pair of complex
/// ones, and an orthonormal complement of the LEFT fast eigenvectors, which J maps into itself. No eigenvector of a
/// slow eigenvalue is used: with a conserved sum they are nearly dependent.
struct divided_modes {
    ball_columns slow, fast;
    std::vector<std::size_t> fast_blocks;  ///< 1 or 2 columns each

    std::size_t size() const { return slow.size() + fast.size(); }
    /// Slow columns first.
    dense_matrix basis() const;
};

/// By FLINT's approximate QR algorithm (acb_mat_approx_eig_qr), in the precision of `bits`. Fast are eigenvalues with a
/// real part below -l, and those that turn by more than 2 l without growing, l in [c, 3 c], c = slowest_fast, at the largest gap between
/// both groups. std::nullopt if the algorithm does not converge.
std::optional<divided_modes> modes_of(const dense_matrix& j, long bits, double slowest_fast);

/// Appends up to `count` orthonormal vectors made of the candidates, with pivots the longest one first [Gram-Schmidt],
/// each orthogonalised twice. In the working precision.
void extend_orthonormal(ball_columns& basis, ball_columns candidates, std::size_t count, bool pivots);

}  // namespace libration::ode
