// Bounds of all derivatives of a function at once.
#pragma once

#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// |F^(j)(u_0)/j!|, j > 0, is at most coefficient j of phi(z) = size exp(z), or size (1 - z/reach)^-power if power > 0,
/// for all u_0 of a set.
struct function_kernel {
    magnitude size;
    magnitude reach;
    unsigned long power = 0;

    /// phi(z), phi'(z), phi''(z); infinite for z >= reach.
    magnitude value(const magnitude& z) const;
    magnitude slope(const magnitude& z) const;
    magnitude second(const magnitude& z) const;
    /// ||phi(h), degrees >= N|| for h with the terms |h_j| rho^j, 0 < j < N; terms[0] is not read. Of the coefficients
    /// M_n of phi(h) those below N are computed. n M_n = sum_j j h_j M_(n-j) for the exponential, n M_n = sum_j (power j +
    /// n - j) g_j M_(n-j) with g = h/reach for the other, so that Y = sum_{n >= N} n M_n rho^n satisfies
    ///     Y <= (the terms with n - j < N) + ||t h'|| Y/N,   or + ||g|| Y + power ||t g'|| Y/N.
    magnitude rest(const std::vector<magnitude>& terms) const;
};

}  // namespace libration::ode
