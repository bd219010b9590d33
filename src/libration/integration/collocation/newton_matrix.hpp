// The matrix of Newton's method for the equations of collocation, factored in double.
#pragma once

#include <cstddef>
#include <vector>

#include "../../algebra/dense_matrix.hpp"

namespace libration::ode {

/// 1 - S (x) J_k, entry ((i, a), (k, c)) = -S_ik J_k,ac off the identity: S integrates between nodes, J_k is f_y at node
/// k times half of the length, in scaled unknowns. Residuals have more digits than corrections.
///
/// With h |lambda| = 1e15 the slow modes are differences of rows that double does not resolve. Therefore each node's rows
/// are first multiplied by a matrix R, in long double: R J is upper triangular in the middle of the step, by elimination
/// with complete pivots, so that its rows are those of fast modes and then smaller ones. R commutes with S.
class newton_matrix {
public:
    /// False if it is singular or not finite. `jacobians` has the matrices by rows, node after node.
    bool factor(const std::vector<long double>& integrals, const std::vector<long double>& jacobians,
                std::size_t unknowns);
    /// Node after node.
    std::vector<long double> solved(const std::vector<long double>& right) const;

private:
    std::vector<long double> reduced(const long double* by_rows, std::size_t columns) const;

    std::size_t unknowns_ = 0;
    std::vector<long double> reduction_;  // R by rows
    real_lu<double> lu_;
};

}  // namespace libration::ode
