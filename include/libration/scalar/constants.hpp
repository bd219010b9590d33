// Constants at the working precision. They are computed anew in every call: a cached one would silently cap a later
// computation of more digits.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <numbers>

#include "libration/scalar/precision.hpp"

namespace libration {

/// pi, correctly rounded.
template <rounding_scalar T>
T pi() {
    if constexpr (std::same_as<T, mpfr>) {
        mpfr value;
        mpfr_const_pi(handle(value), MPFR_RNDN);
        return value;
    } else if constexpr (std::same_as<T, quad>) {
        return boost::math::constants::pi<quad>();
    } else {
        return std::numbers::pi_v<T>;
    }
}

}  // namespace libration
