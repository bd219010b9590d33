// Vandermonde systems: powers of nodes as rows.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration {

/// The solution a of sum_j a_j x_j^n = b_n, n = 0 .. N-1, for N distinct nodes, by the algorithm of [BjorckPereyra1970]
/// (the primal one). O(N^2), exact over fractions. The error of each a_j follows from the rounding errors of the b_n,
/// and so from the condition of the system (vandermonde_condition). Throws error if two nodes are equal, or if the
/// number of right-hand sides is not N.
template <field R>
std::vector<R> solve_vandermonde(const std::vector<R>& nodes, std::vector<R> b) {
    const std::size_t count = nodes.size();
    if (b.size() != count) {
        throw error(error_kind::argument, "number of right-hand sides", std::to_string(b.size()),
                    "is not the number of nodes, " + std::to_string(count));
    }
    for (std::size_t k = 0; k + 1 < count; ++k) {
        for (std::size_t i = count - 1; i > k; --i) {
            b[i] = R(b[i] - nodes[k] * b[i - 1]);
        }
    }
    for (std::size_t k = count; k-- > 0;) {
        for (std::size_t i = k + 1; i < count; ++i) {
            const R distance = R(nodes[i] - nodes[i - k - 1]);
            if (distance == R(0)) {
                throw error(error_kind::argument, "nodes", "", "of a Vandermonde system are not distinct");
            }
            b[i] = R(b[i] / distance);
        }
        for (std::size_t i = k; i + 1 < count; ++i) {
            b[i] = R(b[i] - b[i + 1]);
        }
    }
    return b;
}

/// The condition number ||V|| ||V^-1|| of that system in the maximum norm, for distinct positive nodes: ||V^-1|| is
/// max_j prod_{i != j} (1 + x_i)/|x_j - x_i| [Gautschi1962], ||V|| the largest row sum. Relative error of order N
/// epsilon. O(N^2).
template <rounding_scalar T>
T vandermonde_condition(const std::vector<T>& nodes) {
    using std::abs;
    T of_inverse(0);
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        T product(1);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (i != j) {
                product *= T((1 + nodes[i]) / abs(T(nodes[j] - nodes[i])));
            }
        }
        of_inverse = product > of_inverse ? product : of_inverse;
    }
    std::vector<T> powers(nodes.size(), T(1));
    T of_system(0);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        T row(0);
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            row += powers[j];
            powers[j] *= nodes[j];
        }
        of_system = row > of_system ? row : of_system;
    }
    return of_system * of_inverse;
}

}  // namespace libration
