// The radii of a product of sequences of balls.
#pragma once

#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration {

/// Adds to the radius of c_n an upper bound of sum_k |x_k| s_{n-k} + r_k (|y_{n-k}| + s_{n-k}) for all n below the
/// length of c, where a_k = x_k +- r_k and b_k = y_k +- s_k have moderate exponents (exponent_blocks.hpp), scale is
/// their common slope. O(N^2) products of doubles, for N up to 4096; in longer sequences neighbours share the largest
/// of their bounds.
void add_radii(std::vector<ball>& c, const ball* a, int a_terms, const ball* b, int b_terms, long scale);

}  // namespace libration
