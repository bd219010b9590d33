// The tokens of a problem's text, grouped into statements, and the forms of statements.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

enum class token_kind { numeral, name, symbol };

/// The symbol of +-, -+ and the single characters for them.
inline constexpr char interval_sign = '~';
/// The symbols of == and !=; of `and` and &&; of `or` and ||; of `not` and !.
inline constexpr char equal_sign = '"';
inline constexpr char unequal_sign = '?';
inline constexpr char and_sign = '&';
inline constexpr char or_sign = '|';
inline constexpr char not_sign = '!';
/// The symbol of .. in the range of an index.
inline constexpr char range_sign = '.';

/// A token of the text: a number, a name with its primes, or a symbol ( ) [ ] + - * / ^ = < > :, interval_sign,
/// range_sign, those of conditions, and a comma in parentheses or brackets; <= and >= are < and >. `and`, `or` and `not` are symbols unless
/// the text uses these names with primes or at the beginning of a statement.
struct token {
    token_kind kind = token_kind::symbol;
    std::string text;         ///< in ASCII, without primes
    std::string_view source;  ///< as written, with primes; a part of the text of the problem
    rational value;           ///< of a numeral
    char symbol = ' ';
    int primes = 0;  ///< of a name, and of a bracket ] behind it
    place at;
    bool touches = false;   ///< whether it follows the previous token without a blank
    bool raised = false;    ///< whether it is written as a superscript
    bool or_equal = false;  ///< of < and >: whether it is <= or >=
};

/// The tokens up to ; or the end of a line, or to a comma outside parentheses; at least one.
using statement = std::vector<token>;

/// The text in statements, without comments and blanks, which must outlive them; indices are written out
/// (indexed_statement.hpp): q[1] is a name. Throws error for characters that form no token.
std::vector<statement> statements_of(std::string_view text);

/// The text spanned by the tokens first .. last - 1.
std::string text_of(const statement& words, std::size_t first, std::size_t last);

/// The text of the whole statement.
std::string whole(const statement& words);

/// The whole statement as written, with the tokens first .. last - 1 replaced: the correction in a message. Far from
/// the correction it is cut. An insertion, first == last > 0, replaces blanks before that token.
std::string corrected(const statement& words, std::size_t first, std::size_t last, const std::string& by);

/// Whether the token is this symbol.
bool is_symbol(const token& word, char c);
/// Whether it compares two sides: < > <= >= == !=.
bool is_comparison(const token& word);
/// Whether it combines conditions: `and`, `or`, `not`.
bool is_connective(const token& word);
/// 1 for ( and [, -1 for ) and ], 0 for other tokens.
inline int change_of_depth(const token& word) {
    const bool opens = is_symbol(word, '(') || is_symbol(word, '[');
    return opens ? 1 : is_symbol(word, ')') || is_symbol(word, ']') ? -1 : 0;
}
/// Whether the token of this index exists and is this symbol.
bool symbol_at(const statement& words, std::size_t index, char c);

/// The index of the only = of a statement. Throws error if there is none or more than one, or nothing on one side.
std::size_t equals_of(const statement& words);

/// Whether it begins with this word before another name, as `variable x`.
bool is_keyword(const statement& words, std::string_view name);
/// invariant y^2 + x; also invariant (x + y)/2, but neither invariant = 3 nor invariant(0) = 1.
bool is_invariant(const statement& words);

}  // namespace libration::ode
