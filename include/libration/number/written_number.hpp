// Numbers as written by other programs: decimals and hexadecimal floats, the value of their last digit, and the double
// that a program reads from typed input.
#pragma once

#include <string_view>

#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// Whether the text is [sign]0x..., as written by printf("%a") and float.hex().
bool is_hexadecimal(std::string_view text);

/// digits * base^exponent, and the value of one unit of the last digit.
struct written_number {
    rational value;
    rational last_place;
};

/// base^exponent.
rational power_of(int base, long exponent);

/// Reads [sign]digits[.digits][e[sign]digits] or [sign]0xhex[.hex][p[sign]digits], exactly and without rounding. Throws
/// libration::error with the reason if the text is invalid; fractions and units have no last digit and are rejected.
written_number read_written(std::string_view text);

/// Reads the notation of read_exact() and hexadecimal floats. Throws libration::error.
exact read_typed(std::string_view text);

/// The double nearest to a fraction, ties to even, as an exact number: the input that a program in double receives.
/// Throws error beyond the largest double.
rational nearest_double(const rational& q);

/// The same for a typed number; an angle in degrees or multiples of pi, or an expression, becomes the double nearest to
/// its value. Throws error for a multiple of the period, too.
exact nearest_double(const exact& number);

/// One unit in the last place of a double of the size of q: 2^(e - 53) for 2^(e-1) <= |q| < 2^e, at least 2^-1074.
rational unit_in_last_place(const rational& q);

}  // namespace libration
