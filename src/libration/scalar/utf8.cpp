#include "libration/scalar/utf8.hpp"

#include <algorithm>

namespace libration {

std::size_t bytes_of_character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t bytes = first < 0x80   ? 1
                              : first < 0xc2 ? 0
                              : first < 0xe0 ? 2
                              : first < 0xf0 ? 3
                              : first < 0xf5 ? 4
                                             : 0;
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80; };
    const bool whole = bytes > 0 && bytes <= text.size() && std::ranges::all_of(text.substr(1, bytes - 1), continues);
    return whole ? bytes : 0;
}

bool is_printable(std::string_view character) {
    const auto first = static_cast<unsigned char>(character.front());
    if (character.size() == 1) {
        return first >= ' ' && first < 0x7f;
    }
    return first != 0xc2 || static_cast<unsigned char>(character[1]) >= 0xa0;
}

}  // namespace libration
