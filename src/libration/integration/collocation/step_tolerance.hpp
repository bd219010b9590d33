// The accuracy of a step of collocation in rounded arithmetic.
#pragma once

#include "libration/scalar/scalar.hpp"

namespace libration::ode {

/// Decimal digits of the last Chebyshev coefficients of an unknown, relative to its largest value in the step.
struct step_tolerance {
    double accepted = 0;  ///< of any step
    double aimed = 0;     ///< the target of the step size: errors that the previous step has left are then accepted
    int degree = 0;       ///< of the interpolant of f; the solution is of degree + 1
    /// The binary exponent below which an unknown need not keep its relative accuracy: Jacobians have the range of long
    /// double.
    long least_scale = 0;

    /// For results in double, long double or quad, and in mpfr of the working precision.
    template <rounding_scalar T>
    static step_tolerance of();
};

template <>
step_tolerance step_tolerance::of<double>();
template <>
step_tolerance step_tolerance::of<long double>();
template <>
step_tolerance step_tolerance::of<quad>();
template <>
step_tolerance step_tolerance::of<mpfr>();

}  // namespace libration::ode
