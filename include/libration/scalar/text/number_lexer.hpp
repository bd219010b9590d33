// The one reader of decimals, of hexadecimal floats too: exactly what stands there, nothing rounded.
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
    /// What one unit of the last digit is worth.
    rational last_place() const;
};

/// Takes digits[.digits][e[sign]digits], or hexadecimal digits with p for e, from the front of a text; without a digit
/// before the exponent nothing is taken, and a letter e or p without an exponent behind it stays. Throws
/// libration::error of kind argument beyond 1e-100000 .. 1e100000 and for more than 200000 digits.
std::optional<lexed_number> take_number(std::string_view& rest, radix base = radix::decimal);

/// The sign of an interval at the front of a text, +-, -+ or the one character for it: 1 +- 0.1 is no number, and as
/// 1 + (-0.1) it would be another one.
std::optional<std::string_view> interval_sign_at(std::string_view rest);

/// What is wrong with such a sign, and the remedy.
inline constexpr const char* interval_reason =
    "stands for an interval, which is not supported: write one number, and a negative summand in parentheses";

}  // namespace libration
