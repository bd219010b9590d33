// How a truncated computation remains rigorous, and how it determines where to stop.
//
// Every loop exit and every truncation in this library ends with enclose(value, bound). On a floating-point scalar that
// is the value itself; on a ball it enlarges the radius by the bound, so that the same lines prove their result. Step
// counts come from digits<T>() and binary_exponent(), never from a comparison of computed values, which balls may not
// decide.
#pragma once

#include "libration/scalar/precision.hpp"

namespace libration {

/// The value of a truncated process whose remainder is at most |bound|.
template <has_scalar_traits T>
T enclose(const T& value, const T& bound) {
    return scalar_traits<T>::enclose(value, bound);
}

/// The e with 2^(e-1) <= |x| < 2^e, exponent_of_zero for 0; for a ball, that of the largest |x| in it, within a factor
/// of 2. It determines costs (steps, guard digits), never a result. Throws precision_exhausted for an unbounded ball.
template <has_scalar_traits T>
long binary_exponent(const T& x) {
    return scalar_traits<T>::binary_exponent(x);
}

/// ceil(log2(n)) for n >= 1, and 0 below: the number of doublings needed to reach n.
constexpr int doublings(long n) {
    int steps = 0;
    for (long reached = 1; reached < n; reached *= 2) {
        ++steps;
    }
    return steps;
}

}  // namespace libration
