// arsinh for every scalar. Boost 1.81 declares asinh, log1p and similar functions for float128 in a way that does not
// compile without expression templates; this calls libquadmath directly.
#pragma once

#include <cmath>
#include <concepts>

#include "libration/scalar/precision.hpp"

namespace libration {

/// arsinh x, a few units in the last place, also relative to small values near 0.
template <class T>
requires rounding_scalar<T> || proved_scalar<T> T arsinh(const T& x) {
    using std::asinh;
#if LIBRATION_HAS_FLOAT128
    if constexpr (std::same_as<T, quad>) {
        return quad(asinhq(x.backend().value()));
    } else {
        return asinh(x);
    }
#else
    return asinh(x);
#endif
}

}  // namespace libration
