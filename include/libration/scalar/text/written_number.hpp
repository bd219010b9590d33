// Numbers as other programs write them: decimals and hexadecimal floats, what their last digit is worth, and the double
// that a program makes of what was typed.
#pragma once

#include <string_view>

#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

/// Whether the text is [sign]0x..., as printf("%a") and float.hex() write.
bool is_hexadecimal(std::string_view text);

/// digits * base^exponent, and what one unit of the last digit is worth.
struct written_number {
    rational value;
    rational last_place;
};

/// base^exponent.
rational power_of(int base, long exponent);

/// Reads [sign]digits[.digits][e[sign]digits] or [sign]0xhex[.hex][p[sign]digits], exactly: nothing is rounded. Throws
/// libration::error saying what is wrong with the text; fractions and units have no last digit and are refused.
written_number read_written(std::string_view text);

/// What read_exact() reads, and hexadecimal floats. Throws libration::error.
exact read_typed(std::string_view text);

/// The double nearest to a fraction, ties to even, as an exact number: what a program in double receives.
/// Throws error beyond the largest double.
rational nearest_double(const rational& q);

/// The same of a typed number; an angle in degrees or multiples of pi, or an expression, becomes the double nearest to
/// its value. Throws error for a multiple of the period, too.
exact nearest_double(const exact& number);

}  // namespace libration
