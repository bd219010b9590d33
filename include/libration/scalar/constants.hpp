// Constants at the working precision. They are recomputed in every call: a cached one would silently limit a later
// computation with more digits.
#pragma once

#include "libration/scalar/precision.hpp"

namespace libration {

/// pi, correctly rounded; a proved scalar contains it.
template <has_scalar_traits T>
T pi() {
    return scalar_traits<T>::pi();
}

}  // namespace libration
