// Working precision: how many bits a scalar has, and what follows from it.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/scalar/fixed_traits.hpp"
#include "libration/scalar/mpfr_traits.hpp"
#include "libration/scalar/precision_scope.hpp"
#include "libration/scalar/proved.hpp"
#include "libration/scalar/traits.hpp"

namespace libration {

/// Significand bits of T; of mpfr and ball, those of the working precision in force here.
template <has_scalar_traits T>
constexpr int digits() {
    return scalar_traits<T>::digits();
}

/// Unit in the last place of 1: 2^(1 - digits).
template <has_scalar_traits T>
T epsilon() {
    return scalar_traits<T>::epsilon();
}

/// Whether a number with this binary exponent (2^(e-1) <= |x| < 2^e) is neither below the normal range of T nor above
/// it. The exponents of mpfr and ball never end in practice.
template <has_scalar_traits T>
bool holds_exponent(long exponent) {
    return scalar_traits<T>::holds_exponent(exponent);
}

/// Remembers the precision in which an object computed what it keeps, and refuses a use that asks for more: the digits
/// would be there, and wrong.
template <has_scalar_traits T>
class born_precision {
public:
    /// Throws std::logic_error where the working precision has grown since.
    void require() const {
        if (digits<T>() > digits_) {
            throw std::logic_error("made with " + std::to_string(digits_) + " bits and used with " +
                                   std::to_string(digits<T>()) + ": make it again in the wider precision_scope");
        }
    }

private:
    int digits_ = digits<T>();
};

}  // namespace libration
