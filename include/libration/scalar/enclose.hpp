// How a computation that stops early stays a proof, and how it knows where to stop.
//
// Every loop exit and every truncation in this library ends with enclose(value, bound). On a floating scalar that is
// the value itself; a ball widens its radius by the bound, so that the same lines prove their result. Step counts come
// from digits<T>() and binary_exponent(), never from a comparison of computed values, which no ball decides.
#pragma once

#include <cmath>

#include "libration/scalar/precision.hpp"

namespace libration {

/// The value of a truncated process whose remainder is at most |bound|.
template <rounding_scalar T>
T enclose(const T& value, const T& /*bound*/) {
    return value;
}

/// What binary_exponent() answers for 0: below the exponent of every other number.
inline constexpr long exponent_of_zero = -(1L << 61);

/// The e with 2^(e-1) <= |x| < 2^e. It decides costs (steps, guard digits), never a result.
template <rounding_scalar T>
long binary_exponent(const T& x) {
    if constexpr (std::same_as<T, mpfr>) {
        return mpfr_zero_p(handle(x)) != 0 ? exponent_of_zero : static_cast<long>(mpfr_get_exp(handle(x)));
    } else {
        using std::frexp;
        int exponent = 0;
        frexp(x, &exponent);
        return x == 0 ? exponent_of_zero : exponent;
    }
}

/// ceil(log2(n)) for n >= 1, and 0 below: the number of doublings that reach n.
constexpr int doublings(long n) {
    int steps = 0;
    for (long reached = 1; reached < n; reached *= 2) {
        ++steps;
    }
    return steps;
}

}  // namespace libration
