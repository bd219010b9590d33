// The pole test: if the nearest singularities of f or its derivative are poles, they are the roots of a small Pade
// denominator.
//
// The coefficients of a function whose nearest singularities are M simple poles w_i, and the next at distance R2, are
// sums c_k = sum_i A_i w_i^-k + O(R2^-k): Prony's exponentials [DLMF 3.11(iv); Baker1996, 2.2]. A logarithm A log(1 -
// x/x0) of f is a simple pole of x f', whose coefficients are n a_n; the singularities of the pendulum are of this
// logarithmic type. The error falls like (R/R2)^N for the nearest singularity that the degree does not represent. If
// the singularities are neither poles nor logarithms it converges slowly; its uncertainty is then of the size of its
// error.
#pragma once

#include "libration/convergence/recurrence_estimate.hpp"

namespace libration::convergence {

/// Poles of f. Needs six coefficients. O(M^3) per degree M <= 40 tried.
template <rounding_scalar T>
radius_estimate<T> pole_test(const strided_series<T>& c) {
    return estimate_by_recurrence("pole", c, recurrence_form{0, 0});
}

/// Poles of x f', n a_n instead of a_n: logarithms of f. Needs six coefficients. O(M^3) per degree M <= 40 tried.
template <rounding_scalar T>
radius_estimate<T> pole_test_of_derivative(const strided_series<T>& c) {
    return estimate_by_recurrence("pole-of-derivative", c, recurrence_form{1, 1});
}

}  // namespace libration::convergence
