// Differential approximants: position and exponent of the nearest singularities, whatever the exponent.
//
// f is fitted by a solution of sum_{i=0}^{d} Q_i(w) (x d/dx)^i f = P(w), w = x^stride, deg Q_i <= M, inhomogeneous, so
// that terms analytic at the singularity do not disturb the fit [Guttmann1989, 3.2; Hunter1979]. Singularities are the
// roots of Q_d; there f ~ (1 - x/x0)^nu with nu = d - 1 - Q_{d-1}/(stride w Q_d'), exactly so for (1 - x)^nu and its
// sum with a polynomial. d = 1 includes poles and logarithms; d = 2 also mixtures such as A + B (1 - x)^(1/2) with
// varying A and B. Fails if singularities are so close together that the degree does not resolve them.
#pragma once

#include "libration/convergence/recurrence_estimate.hpp"

namespace libration::convergence {

/// First order. Needs eight coefficients. O(M^3) per degree M <= 31 tried.
template <rounding_scalar T>
radius_estimate<T> differential_approximants(const strided_series<T>& c) {
    return estimate_by_recurrence("differential-approximant", c, recurrence_form{0, 1});
}

/// Second order. Needs ten coefficients. O(M^3) per degree M <= 20 tried.
template <rounding_scalar T>
radius_estimate<T> second_order_approximants(const strided_series<T>& c) {
    return estimate_by_recurrence("differential-approximant-2", c, recurrence_form{0, 2});
}

}  // namespace libration::convergence
