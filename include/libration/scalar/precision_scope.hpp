// The single scoped object that sets the working precision where it is a run-time choice: for mpfr and for balls.
#pragma once

#include <string>

#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// Sets the working precision of this thread, in decimal digits, until the end of the scope; scopes nest.
///
/// MPFR's default precision is thread-local state: every worker thread opens its own scope. The precision in bits is
/// the smallest that Boost assigns to that many digits, never less than digits * log2(10).
/// Throws error if digits is outside 1 .. 10^8.
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

/// The current working precision of this thread, in decimal digits.
inline long working_digits() { return static_cast<long>(mpfr::thread_default_precision()); }

/// A number of decimal digits that suffices for `bits` bits: bits log10 2, rounded up.
constexpr long decimal_digits(long bits) { return bits <= 0 ? 1 : (bits * 30103 + 99'999) / 100'000; }

}  // namespace libration
