// A ball as integers and powers of 2, exactly: for programs with their own ball type.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// mantissa 2^exponent +- radius 2^radius_exponent.
struct binary_parts {
    integer mantissa;
    long exponent;
    unsigned long radius;  ///< of at most 30 bits
    long radius_exponent;
};

/// The parts of a ball. Throws error of the kind range if it is infinite or an exponent is out of range of a long.
binary_parts parts_of(const ball& x);

}  // namespace libration
