// Working precision: the number of bits of a scalar, and derived quantities.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/scalar/fixed_traits.hpp"
#include "libration/scalar/mpfr_traits.hpp"
#include "libration/scalar/precision_scope.hpp"
#include "libration/scalar/proved.hpp"
#include "libration/scalar/traits.hpp"

namespace libration {

/// Significand bits of T; for mpfr and ball, those of the current working precision.
template <has_scalar_traits T>
constexpr int digits() {
    return scalar_traits<T>::digits();
}

/// Unit in the last place of 1: 2^(1 - digits).
template <has_scalar_traits T>
T epsilon() {
    return scalar_traits<T>::epsilon();
}

/// Whether a number with this binary exponent (2^(e-1) <= |x| < 2^e) is within the normal range of T. The exponents of
/// mpfr and ball are unlimited in practice.
template <has_scalar_traits T>
bool holds_exponent(long exponent) {
    return scalar_traits<T>::holds_exponent(exponent);
}

/// Records the precision in which an object computed its stored values, and throws if it is used with a higher one: the
/// additional digits would be wrong.
template <has_scalar_traits T>
class born_precision {
public:
    /// Throws std::logic_error if the working precision has increased since.
    void require() const {
        if (digits<T>() > digits_) {
            throw std::logic_error("computed with " + std::to_string(digits_) + " bits and used with " +
                                   std::to_string(digits<T>()) + ": recompute it in the wider precision_scope");
        }
    }

private:
    int digits_ = digits<T>();
};

}  // namespace libration
