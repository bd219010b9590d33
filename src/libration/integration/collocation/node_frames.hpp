// A moving frame at the nodes, in balls or in double.
#pragma once

#include <memory>
#include <vector>

#include "chebyshev_zeros.hpp"
#include "step_suprema.hpp"

namespace libration::ode {

/// V, W and the matrices of theorem K at a node.
struct node_frame {
    dense_matrix frame, inverse;
    dense_matrix linear;  ///< W (J V - V')
    dense_matrix unit;    ///< W V - 1
};

/// J at a node: its entries that are not identically 0, and their rows and columns.
struct sparse_entries {
    const std::vector<std::pair<std::size_t, std::size_t>>& places;
    const std::vector<ball>& values;
};

class node_frames {
public:
    virtual ~node_frames() = default;
    /// At node k; successive nodes are cheapest in the order 0, M - 1, 1, M - 2, ..
    virtual node_frame at(int k, const sparse_entries& jacobian) = 0;
};

/// In balls, polynomials in `bits`, their values rounded to `node_bits`, in which matrices are multiplied.
std::unique_ptr<node_frames> frames_in_balls(const moving_frame& of, const chebyshev_zeros& at, long bits,
                                             long node_bits);
/// In double, for frames whose `inverse` and fast columns are constant, with a `change` for each slow mode or all constant; Chebyshev coefficients of
/// polynomials in `bits`. For many unknowns at a small part of the cost.
std::unique_ptr<node_frames> frames_in_double(const moving_frame& of, const chebyshev_zeros& at, long bits);

}  // namespace libration::ode
