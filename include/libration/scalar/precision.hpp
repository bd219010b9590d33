// Working precision: how many bits a scalar has, and the one scoped object that sets it where it is a run-time choice.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>

#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/proved.hpp"
#include "libration/scalar/quad.hpp"

namespace libration {

/// A floating scalar whose precision is part of its type.
template <class T>
concept fixed_scalar = std::same_as<T, double> || std::same_as<T, long double> || std::same_as<T, quad>;

/// A scalar that rounds (and proves nothing): everything but a ball, which is a proved_scalar.
template <class T>
concept rounding_scalar = fixed_scalar<T> || std::same_as<T, mpfr>;

/// Sets the working precision of this thread, in decimal digits, until the end of the scope; scopes nest.
///
/// MPFR's default precision is thread-local state: every worker thread opens a scope of its own. The precision in bits
/// is the smallest that Boost gives for that many digits, never less than digits * log2(10).
/// Throws error when digits is outside 1 .. 10^8.
class precision_scope {
public:
    explicit precision_scope(long digits) : previous_(mpfr::thread_default_precision()) {
        if (digits < 1 || digits > maximum) {
            throw error(error_kind::argument, "working precision", std::to_string(digits),
                        "is outside 1 .. 10^8 digits");
        }
        mpfr::thread_default_precision(static_cast<unsigned>(digits));
    }
    precision_scope(const precision_scope&) = delete;
    precision_scope& operator=(const precision_scope&) = delete;
    ~precision_scope() { mpfr::thread_default_precision(previous_); }

private:
    static constexpr long maximum = 100'000'000;
    unsigned previous_;
};

/// The working precision in force in this thread, in decimal digits.
inline long working_digits() { return static_cast<long>(mpfr::thread_default_precision()); }

/// A number of decimal digits that holds `bits` bits: bits log10 2, rounded up.
constexpr long decimal_digits(long bits) { return bits <= 0 ? 1 : (bits * 30103 + 99'999) / 100'000; }

/// Significand bits of T; of mpfr, those of the working precision in force here.
template <rounding_scalar T>
int digits() {
    if constexpr (std::same_as<T, mpfr>) {
        return static_cast<int>(mpfr_get_prec(handle(mpfr())));
    } else {
        return std::numeric_limits<T>::digits;
    }
}

/// Remembers the precision in which an object computed what it keeps, and refuses a use that asks for more: the digits
/// would be there, and wrong.
template <class T>
requires rounding_scalar<T> || proved_scalar<T>
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

/// Whether a number with this binary exponent (2^(e-1) <= |x| < 2^e) is neither below the normal range of T nor above
/// it. The exponents of mpfr and ball never end in practice.
template <class T>
requires rounding_scalar<T> || proved_scalar<T>
bool holds_exponent(long exponent) {
    if constexpr (std::same_as<T, mpfr> || proved_scalar<T>) {
        return true;
    } else {
        return exponent >= std::numeric_limits<T>::min_exponent && exponent <= std::numeric_limits<T>::max_exponent;
    }
}

/// Unit in the last place of 1: 2^(1 - digits).
template <rounding_scalar T>
T epsilon() {
    using std::ldexp;
    return ldexp(T(1), 1 - digits<T>());
}

}  // namespace libration
