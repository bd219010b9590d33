// The characters of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace libration {

/// The bytes of the character at the front of a text that is not empty; 0 if its first byte is not part of one.
std::size_t bytes_of_character(std::string_view text);

/// Whether it is one character without control characters: as a part of a message.
bool is_printable(std::string_view character);

}  // namespace libration
