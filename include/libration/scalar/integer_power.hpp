// Powers with integer exponents, of real and complex numbers.
#pragma once

#include <bit>

#include "libration/scalar/complex_number.hpp"

namespace libration {

/// z^n, n >= 0, by squaring from the highest bit of n on: O(log n) products. Relative to |z|^n an error of n epsilon;
/// on balls up to sqrt 2 times that per product.
template <field R>
R integer_power(const R& z, long n) {
    R power(1);
    const auto exponent = static_cast<unsigned long>(n);
    for (unsigned long bit = std::bit_floor(exponent); bit > 0; bit /= 2) {
        power = power * power;
        if ((exponent & bit) != 0) {
            power = power * z;
        }
    }
    return power;
}

}  // namespace libration
