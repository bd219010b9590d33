// Matrices in double with bounds of their errors: products of many unknowns for a small part of the work of balls.
#pragma once

#include <cstddef>
#include <vector>

#include "dense_matrix.hpp"

namespace libration::ode {

/// From so many unknowns on, frames are computed in double, and eigenvectors too.
constexpr std::size_t least_size_in_double = 50;

/// Encloses every matrix whose entries differ from `values` by at most `errors`, both by rows. Where double overflows,
/// errors are infinite or NaN, and balls of them are without bounds.
struct rounded_matrix {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> values, errors;

    rounded_matrix() = default;
    rounded_matrix(std::size_t r, std::size_t c) : rows(r), columns(c), values(r * c, 0), errors(r * c, 0) {}
    /// The entries of balls, by rows.
    rounded_matrix(std::size_t r, std::size_t c, const std::vector<ball>& entries);
    explicit rounded_matrix(const dense_matrix& of) : rounded_matrix(of.rows, of.columns, of.entries) {}

    ball entry(std::size_t i, std::size_t j) const;
    dense_matrix balls() const;
    /// The rows begin, .. , begin + count - 1.
    rounded_matrix part(std::size_t begin, std::size_t count) const;
};

/// An upper bound of the sum of so many terms >= 0 that was computed in double, in any order: each of at most 2^12
/// operations changes it by a factor of at least 1 - 2^-53, or by less than 2^-1074 where it underflows.
inline double upper_bound_of_sum(double computed) { return computed * (1 + 0x1p-40) + 0x1p-1060; }

/// One product in double by Eigen. With a = A + da, b = B + db, A and B the values, and n columns of a,
///     |(a b - fl(A B))_ij| <= g |A_i| |B_j| + |da_i| |B_j| + |a_i| |db_j| + 2 n 2^-1074,   g = n 2^-53/(1 - n 2^-53),
/// |.| the Euclidean lengths of rows i and columns j: Cauchy's inequality, and the error of a sum of n products in any
/// order and with or without fused operations [Higham2002, (3.5)], n larger by 3 for the operations of Eigen. At most
/// 4000 columns, so that upper_bound_of_sum contains the last term.
rounded_matrix product(const rounded_matrix& a, const rounded_matrix& b);
rounded_matrix sum(rounded_matrix a, const rounded_matrix& b);
rounded_matrix difference(rounded_matrix a, const rounded_matrix& b);

/// The product of matrices of doubles by rows without bounds: a has `rows` of them and b `columns` columns.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b, std::size_t rows,
                            std::size_t columns);
/// The midpoints.
std::vector<double> in_double(const std::vector<ball>& entries);

}  // namespace libration::ode
