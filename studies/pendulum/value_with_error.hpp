// Values of theta with their errors against the exact solution, with as many digits as the smallest error needs.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/enclose.hpp"

namespace libration::studies {

/// theta and omega by some method, and |theta - exact|. If the two are equal in exact arithmetic, the remaining error
/// is rounding and `settled` is true: no precision resolves it.
struct value_with_error {
    mpfr theta;
    mpfr omega;
    mpfr error;
    bool settled = false;
};

/// Digits that a computation carries beyond those it prints.
inline constexpr long guard_digits = 15;

/// The working precision in which all three have their digits correct; 0 if there are none.
inline long digits_to_resolve(const value_with_error& value, long digits) {
    if (value.settled && value.error == 0) {
        return 0;
    }
    if (value.error == 0) {
        return working_digits() * 2;
    }
    const long largest = std::max({binary_exponent(value.theta), binary_exponent(value.omega), 1L});
    long smallest = binary_exponent(value.error);
    for (const mpfr& each : {value.theta, value.omega}) {
        smallest = each == 0 ? smallest : std::min(smallest, binary_exponent(each));
    }
    return digits + guard_digits + decimal_digits(std::max(largest - smallest, 0L));
}

/// compute(), which returns value_with_error values, in a working precision of `digits` and `more` initially and then
/// as the smallest value or error requires. Throws error of the kind undecided if 100000 digits do not resolve one.
template <class Compute>
std::vector<value_with_error> resolved(long digits, long more, const Compute& compute) {
    constexpr long most_working_digits = 100'000;
    const auto attempt = [&](long& working) -> std::optional<std::vector<value_with_error>> {
        std::vector<value_with_error> values = compute();
        long needed = 0;
        for (const value_with_error& value : values) {
            needed = std::max(needed, digits_to_resolve(value, digits));
        }
        if (needed <= working) {
            return values;
        }
        working = needed + guard_digits;
        return std::nullopt;
    };
    return with_asked_precision(digits + more + guard_digits, most_working_digits, "an error", attempt);
}

}  // namespace libration::studies
