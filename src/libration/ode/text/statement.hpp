// The words of a problem's text, in statements.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

enum class token_kind { numeral, name, symbol };

/// A word of the text: a number, a name with its primes, or a symbol ( ) + - * / ^ =.
struct token {
    token_kind kind = token_kind::symbol;
    std::string_view text;
    rational value;  ///< of a numeral
    char symbol = ' ';
    int primes = 0;
    place at;
    bool touches = false;  ///< the token before, without a blank
};

/// The words up to ; or the end of a line, at least one.
using statement = std::vector<token>;

/// The text in statements, without comments and blanks. Throws error for what is no word.
std::vector<statement> statements_of(std::string_view text);

/// The text that the tokens first .. last - 1 stand in.
std::string text_of(const statement& words, std::size_t first, std::size_t last);

}  // namespace libration::ode
