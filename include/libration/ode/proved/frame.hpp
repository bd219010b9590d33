// Sets of errors as images of boxes, which turn with the flow: the linear algebra of theorem V.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// Rows of a square matrix.
using ball_matrix = std::vector<std::vector<ball>>;

/// The midpoint, rounded to the working precision, as an exact ball.
ball exact_midpoint(const ball& x);

/// a b.
ball_matrix product(const ball_matrix& a, const ball_matrix& b);

/// Q [-r, r]: an exact matrix Q, nearly orthogonal, times a box.
class error_frame {
public:
    /// The box itself.
    explicit error_frame(std::vector<magnitude> widths);

    std::size_t size() const { return widths_.size(); }
    /// Q by columns, and r.
    const ball_matrix& columns() const { return columns_; }
    const std::vector<magnitude>& widths() const { return widths_; }
    /// A bound of |x_i| over the set.
    magnitude reach(std::size_t i) const;
    /// x_i over the set A Q [-r, r] for every matrix of the balls A.
    magnitude reach(const ball_matrix& map, std::size_t i) const;

    /// A set that holds A x + e for every x of this one, every matrix of A and |e_i| <= added_i:
    ///     r' = |Q'^-1 A Q| r + |Q'^-1| added,
    /// Q' the orthogonal factor of the midpoint of A Q, its columns in the order of their lengths times r [Lohner].
    /// In the working precision, which 64 bits suffice for. Throws precision_exhausted where A is not finite.
    error_frame moved(const ball_matrix& map, const std::vector<magnitude>& added) const;

private:
    ball_matrix columns_;  // Q by columns, exact
    std::vector<magnitude> widths_;
};

}  // namespace libration::ode
