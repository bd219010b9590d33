// The characters of equations, in UTF-8: those beyond ASCII as they are printed in books, with their ASCII spelling.
#pragma once

#include <string>
#include <string_view>

namespace libration::ode {

enum class character_kind {
    ascii,
    letter,       ///< a Greek letter: its name, theta
    subscript,    ///< a digit in a name
    superscript,  ///< a digit, + or - of an exponent
    prime,        ///< one or more '
    symbol,       ///< another form of * / or -
    word,         ///< a whole name: pi, inf, deg, sqrt
    blank,        ///< a blank of another width
    other         ///< none of these, or not UTF-8
};

/// The first character of a text.
struct character {
    std::string_view source;  ///< at least one byte
    std::string_view ascii;   ///< the spelling in ASCII; empty for a blank and for others
    character_kind kind = character_kind::other;
};

/// The text must not be empty.
character first_character(std::string_view text);

/// The number of characters of a text, where each byte that is not part of UTF-8 counts as one.
std::size_t characters_in(std::string_view text);

/// Whether the name is that of a Greek letter, in ASCII.
bool is_greek_name(std::string_view name);

}  // namespace libration::ode
