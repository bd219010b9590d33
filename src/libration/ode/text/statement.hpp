// The tokens of a problem's text, grouped into statements.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

enum class token_kind { numeral, name, symbol };

/// A token of the text: a number, a name with its primes, or a symbol ( ) + - * / ^ =.
struct token {
    token_kind kind = token_kind::symbol;
    std::string_view text;
    rational value;  ///< of a numeral
    char symbol = ' ';
    int primes = 0;
    place at;
    bool touches = false;  ///< whether it follows the previous token without a blank
};

/// The tokens up to ; or the end of a line, at least one.
using statement = std::vector<token>;

/// The text in statements, without comments and blanks. Throws error for characters that form no token.
std::vector<statement> statements_of(std::string_view text);

/// The text spanned by the tokens first .. last - 1.
std::string text_of(const statement& words, std::size_t first, std::size_t last);

}  // namespace libration::ode
