// The matrix of Newton's method for collocation, in double, on which no proof depends.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace libration::ode {

/// 1 - S (x) B: S integrates over m nodes, and B_k is the n by n Jacobian at node k in a basis of modes. Unknown a at
/// node k has the index k n + a. Up to 2500 unknowns by LU of the whole; beyond, by iterative refinement with the blocks
/// of modes alone, each over all nodes: a step in which they are not coupled much more than that needs few iterations.
class collocation_matrix {
public:
    collocation_matrix();
    ~collocation_matrix();

    /// S and each B_k by rows; `blocks` are the numbers of modes in the blocks of B. False if a matrix is singular.
    bool factor(const std::vector<double>& integrals, std::vector<std::vector<double>> jacobians,
                const std::vector<std::size_t>& blocks);
    /// For other Jacobians; the factors of blocks are kept, because the refinement corrects them.
    bool update(std::vector<std::vector<double>> jacobians);
    /// For so many right-hand sides, the columns of a matrix by rows.
    std::vector<double> solved(const std::vector<double>& right, std::size_t columns) const;

private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

}  // namespace libration::ode
