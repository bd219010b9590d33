// The single reader of decimals, including hexadecimal floats: exact, without rounding.
#pragma once

#include <optional>
#include <string_view>

#include "libration/scalar/mpfr.hpp"

namespace libration {

enum class radix { decimal, hexadecimal };

/// significand * 10^scale or significand * 2^scale.
struct lexed_number {
    integer significand;
    long scale;  ///< of the last digit
    radix base;

    rational value() const;
    /// The value of one unit of the last digit.
    rational last_place() const;
};

/// Takes digits[.digits][e[sign]digits], or hexadecimal digits with p for e, from the front of a text; without a digit
/// before the exponent nothing is taken, and a letter e or p without a following exponent is left. Throws
/// libration::error of kind argument beyond 1e-100000 .. 1e100000 and for more than 200000 digits.
std::optional<lexed_number> take_number(std::string_view& rest, radix base = radix::decimal);

/// The sign of an interval at the front of a text, +-, -+ or the single character for it: 1 +- 0.1 is not a number, and
/// read as 1 + (-0.1) it would be a different one.
std::optional<std::string_view> interval_sign_at(std::string_view rest);

/// The error message for such a sign, with the remedy.
inline constexpr const char* interval_reason =
    "denotes an interval, which is not supported here: write one number, and a negative summand in parentheses";

}  // namespace libration
