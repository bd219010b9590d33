// Pseudo-arclength continuation in floating-point arithmetic: first guesses for proofs, on which no proof depends.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/algebra/krawczyk.hpp"

namespace libration::ode {

/// A point of a branch z = (x, lambda), and the direction in which it is followed, of length 1 in the norm of its
/// weights.
struct branch_node {
    std::vector<double> z;
    std::vector<double> tangent;
    std::vector<double> weights;  ///< 1/max(1, |x_i|), and 1/range of lambda
};

/// sqrt(sum (w_i a_i)^2).
double weighted_length(const std::vector<double>& weights, const std::vector<double>& a);

/// The curve between two nodes: the cubic with their points and tangents.
class branch_piece {
public:
    branch_piece(const branch_node& from, const branch_node& to);
    /// The point at 0 <= part <= 1.
    std::vector<double> at(double part) const;
    /// The part at which lambda has this value, by bisection: lambda is monotone on the piece and passes it.
    double part_at(double lambda) const;
    /// Of the chord, in the weights of its end.
    double length() const { return length_; }

private:
    const branch_node& from_;
    const branch_node& to_;
    double length_;
};

/// The steps along F(z) = 0: a predictor along the tangent and Newton's method on the plane through it across the
/// tangent [Keller1977]. The tangent turns by at most 18 degrees in a step.
class branch_path {
public:
    /// `range` is the distance of the values of lambda.
    branch_path(const map_of_unknowns& f, double range) : f_(f), range_(range) {}

    /// The node at a point of the curve; lambda moves by the sign of `direction`. Returns std::nullopt if the curve has
    /// no tangent there.
    std::optional<branch_node> begin(const std::vector<double>& z, double direction) const;
    /// The node at this point of the curve with the tangent nearest to that of another node.
    std::optional<branch_node> node_at(const std::vector<double>& z, const std::vector<double>& tangent_near) const;
    /// The next node. Returns std::nullopt if the steps become too small.
    std::optional<branch_node> next(const branch_node& from);

private:
    struct linear_map {
        std::vector<double> value;
        std::vector<double> rows;  // n by n + 1
    };
    std::optional<linear_map> map_at(const std::vector<double>& z) const;
    std::vector<double> weights_at(const std::vector<double>& z) const;
    std::optional<branch_node> corrected(const branch_node& from, double step) const;

    const map_of_unknowns& f_;
    double range_;
    double step_ = 0.02;
};

}  // namespace libration::ode
