// Inputs in messages: short, and as characters that a terminal only shows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "libration/scalar/error.hpp"

namespace libration {

/// The characters that a message quotes of an input.
inline constexpr std::size_t longest_quotation = 60;

/// A text with at most so many of its characters and "..." for the rest. Control characters and bytes that are not
/// UTF-8 become \n, \t, \r, \0 or \x1b. Cost: as many characters.
std::string without_controls(std::string_view text, std::size_t most);

/// An input in quotes, cut and without control characters.
std::string quotation(std::string_view input);

/// A whole message, whose quoted parts ('...') are cut in the same way: a line of at most 2000 characters.
std::string shortened(std::string_view message);

/// The message of an error, with its value quoted in this way: what() ends where the value has a NUL.
std::string message_of(const error& problem);

}  // namespace libration
