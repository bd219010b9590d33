// Error sets as images of boxes, which rotate with the flow (Lohner sets): the sets of theorems V and K.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// { sum_b B_b x_b + a : |x_b| <= r_b, |a_i| <= e_i }, B_b the columns of a block, one or two of them, with the Euclidean
/// norm; columns of balls represent each of their matrices. Theorem V has blocks of one: B [-r, r] + [-e, e], and after
/// settled() B = S Q, S a diagonal matrix of powers of two, Q exact and nearly orthogonal, and e = 0. In theorem K the
/// columns need not be as many as the coordinates. In theorem V there may be more: then those that exceed the number of
/// coordinates, the first ones, are followed separately, C [-q, q] + B [-r, r] + [-e, e] (two images of boxes
/// [MrozekZgliczynski2000]), so that a wide set is not wrapped in Q.
class lohner_set {
public:
    lohner_set() = default;
    /// The box itself.
    explicit lohner_set(std::vector<magnitude> radii);
    /// By the columns of B, the number of columns of each block, r and e.
    lohner_set(ball_matrix columns, std::vector<std::size_t> blocks, std::vector<magnitude> radii,
               std::vector<magnitude> added)
        : columns_(std::move(columns)),
          blocks_(std::move(blocks)),
          radii_(std::move(radii)),
          added_(std::move(added)) {}

    /// The number of coordinates.
    std::size_t size() const { return added_.size(); }
    const ball_matrix& columns() const { return columns_; }
    const std::vector<std::size_t>& blocks() const { return blocks_; }
    const std::vector<magnitude>& radii() const { return radii_; }
    const std::vector<magnitude>& added() const { return added_; }
    /// A bound of |x_i| over the set.
    magnitude reach(std::size_t i) const;
    /// A bound of |x_i| over the set A x, x in this one, for every matrix of the balls A.
    magnitude reach(const ball_matrix& map, std::size_t i) const;
    /// The radius of each column: a block of two with the Euclidean norm lies in a box.
    std::vector<magnitude> radii_of_columns() const;

    /// Adds a coordinate: g x + e for every x of the set, every g of the row and |e| <= added.
    void add_coordinate(const std::vector<ball>& row, magnitude added);
    /// The set of A x + e for every x of this one, every matrix of A and |e_i| <= added_i: the columns are A B. Throws
    /// precision_exhausted if A is not finite.
    lohner_set image(const ball_matrix& map, const std::vector<magnitude>& added) const;

    /// A set S Q [-r', r'] that contains this one, S = diag(2^scales_i), scales 0 if none are given. Of more columns than
    /// coordinates the first ones remain, rounded, with their errors in e; the others become separate ones too, up to a
    /// limit, when they are not small next to them. For as many:
    ///     r' = |Q^-1 S^-1 B| r + |Q^-1| S^-1 e,
    /// Q the orthogonal factor of the midpoint of S^-1 B, its columns in the order of their lengths times r [Lohner].
    /// With scales near the sizes of the unknowns the set is as narrow relative to the smallest as to the largest of
    /// them. A coordinate that is 0 on the whole set remains 0: |B_i| r + e_i = 0 for the rows i of a set Z, so the set
    /// lies in the subspace x_Z = 0, in which the columns of Q are orthogonalised, in addition to the unit vectors of
    /// Z. Computed in the working precision; 64 bits suffice.
    lohner_set settled(const std::vector<long>& scales = {}) const;

    /// image(map, added).settled().
    lohner_set moved(const ball_matrix& map, const std::vector<magnitude>& added) const {
        return image(map, added).settled();
    }

private:
    lohner_set settled_behind(std::size_t kept, const std::vector<long>& scales) const;
    magnitude reach_of(std::size_t first, std::size_t last, std::size_t i) const;
    bool is_wide_behind(std::size_t kept) const;
    void keep_all_columns(const std::vector<long>& scales);

    ball_matrix columns_;
    std::vector<std::size_t> blocks_;
    std::vector<magnitude> radii_, added_;
};

/// sum_b |row_b| r_b, row_b the part of a row in block b, with the Euclidean norm.
magnitude reach_of_row(const std::vector<ball>& row, const std::vector<std::size_t>& blocks,
                       const std::vector<magnitude>& radii);

/// c + E, c exact: encloses the state of each solution that an integration follows.
struct state_set {
    std::vector<ball> centre;
    lohner_set errors;

    /// A bound of |y_i - centre_i| over the set.
    magnitude reach(std::size_t i) const { return errors.reach(i); }
    /// The smallest box that is known to contain the set.
    std::vector<ball> hull() const;
};

}  // namespace libration::ode
