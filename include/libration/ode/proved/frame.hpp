// Error sets as images of boxes, which rotate with the flow (Lohner sets): the linear algebra of theorem V.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// Rows of a square matrix.
using ball_matrix = std::vector<std::vector<ball>>;

/// The midpoint, rounded to the working precision, as an exact ball.
ball exact_midpoint(const ball& x);

/// a b.
ball_matrix product(const ball_matrix& a, const ball_matrix& b);

/// B [-r, r] + [-e, e], B a matrix of balls: an error set of theorem V. After settled(), B = S Q, S a diagonal matrix
/// of powers of two, Q exact and nearly orthogonal, and e = 0.
class error_frame {
public:
    /// The box itself.
    explicit error_frame(std::vector<magnitude> widths);
    /// By B in columns, r and e.
    error_frame(ball_matrix columns, std::vector<magnitude> widths, std::vector<magnitude> added)
        : columns_(std::move(columns)), widths_(std::move(widths)), added_(std::move(added)) {}

    std::size_t size() const { return widths_.size(); }
    /// B by columns, r and e.
    const ball_matrix& columns() const { return columns_; }
    const std::vector<magnitude>& widths() const { return widths_; }
    const std::vector<magnitude>& added() const { return added_; }
    /// A bound of |x_i| over the set.
    magnitude reach(std::size_t i) const;
    /// A bound of |x_i| over the set A x, x in this one, for every matrix of the balls A.
    magnitude reach(const ball_matrix& map, std::size_t i) const;

    /// The set of A x + e for every x of this one, every matrix of A and |e_i| <= added_i: the columns are A B. Throws
    /// precision_exhausted if A is not finite.
    error_frame image(const ball_matrix& map, const std::vector<magnitude>& added) const;

    /// A set S Q [-r', r'] that contains this one, S = diag(2^scales_i), scales 0 if none are given:
    ///     r' = |Q^-1 S^-1 B| r + |Q^-1| S^-1 e,
    /// Q the orthogonal factor of the midpoint of S^-1 B, its columns in the order of their lengths times r [Lohner].
    /// With scales near the sizes of the unknowns the set is as narrow relative to the smallest as to the largest of
    /// them. A coordinate that is 0 on the whole set remains 0: |B_i| r + e_i = 0 for the rows i of a set Z, so the set
    /// lies in the subspace x_Z = 0, in which the columns of Q are orthogonalised, in addition to the unit vectors of
    /// Z. Computed in the working precision; 64 bits suffice.
    error_frame settled(const std::vector<long>& scales = {}) const;

    /// image(map, added).settled().
    error_frame moved(const ball_matrix& map, const std::vector<magnitude>& added) const {
        return image(map, added).settled();
    }

private:
    ball_matrix columns_;  // B by columns
    std::vector<magnitude> widths_, added_;
};

}  // namespace libration::ode
