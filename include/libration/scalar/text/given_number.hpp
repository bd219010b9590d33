// Exact numbers of a named quantity: what is wrong with them is said with the name and the text.
#pragma once

#include <string>

#include "libration/scalar/exact.hpp"

namespace libration {

/// The exact number that a text stands for. Throws error of the kind argument with the quantity, the text and the
/// reason.
exact given_number(const std::string& quantity, const std::string& text);

/// The same for what must have no unit.
rational given_fraction(const std::string& quantity, const std::string& text);

/// The same for an angle: a number, a multiple of pi or degrees, no multiple of a period.
exact given_angle(const std::string& quantity, const std::string& text);

/// The same for a time: a number or a multiple of the period T, no degrees.
exact given_time(const std::string& quantity, const std::string& text);

/// `digits`, where they are from 1 to most_digits.
long given_digits(long digits);

}  // namespace libration
