// arsinh for every scalar. Boost 1.81 declares asinh, log1p and their kin for float128 so that they do not compile
// without expression templates; this goes to libquadmath itself.
#pragma once

#include <cmath>
#include <concepts>

#include "libration/scalar/precision.hpp"

namespace libration {

/// arsinh x, a few units in the last place, relative next to 0 too.
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
