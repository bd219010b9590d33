// Exact numbers of a named quantity: error messages contain the name and the text.
#pragma once

#include <string>

#include "libration/number/exact.hpp"

namespace libration {

/// The exact number represented by a text. Throws error of the kind argument with the quantity, the text and the
/// reason.
exact given_number(const std::string& quantity, const std::string& text);

/// The same for a number without a unit.
rational given_fraction(const std::string& quantity, const std::string& text);

/// The same for an angle: a number, a multiple of pi or degrees, not a multiple of a period.
exact given_angle(const std::string& quantity, const std::string& text);

/// The same for a time: a number or a multiple of the period T, not in degrees.
exact given_time(const std::string& quantity, const std::string& text);

/// `digits`, provided they are from 1 to most_digits.
long given_digits(long digits);

}  // namespace libration
