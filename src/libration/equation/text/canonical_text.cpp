// Problems in standard notation.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "event_statement.hpp"
#include "libration/equation/text/parse.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

bool is_operand(const token& word) { return word.kind != token_kind::symbol || word.symbol == '('; }

std::string text_of_symbol(const token& word) {
    constexpr std::array<std::pair<char, std::string_view>, 6> spaced{{{interval_sign, " +- "},
                                                                       {equal_sign, " == "},
                                                                       {unequal_sign, " != "},
                                                                       {and_sign, " and "},
                                                                       {or_sign, " or "},
                                                                       {not_sign, "not "}}};
    const auto* const found = std::ranges::find(spaced, word.symbol, &std::pair<char, std::string_view>::first);
    if (found != spaced.end()) {
        return std::string(found->second);
    }
    const std::string symbol(1, word.symbol);
    return word.or_equal ? symbol + "=" : word.symbol == ',' || word.symbol == ':' ? symbol + " " : symbol;
}

std::string text_of_token(const token& word) {
    switch (word.kind) {
        case token_kind::numeral: return word.raised ? word.value.str() : word.text;
        case token_kind::name: return primed(word.text, word.primes);
        case token_kind::symbol: return text_of_symbol(word);
    }
    return {};
}

// The signs of sums have blanks around them, unless they are signs of a number or in an exponent.
bool is_operator_of_sum(const statement& words, std::size_t at) {
    const bool sign = is_symbol(words[at], '+') || is_symbol(words[at], '-');
    return sign && at > 0 && (words[at - 1].kind != token_kind::symbol || is_symbol(words[at - 1], ')'));
}

class canonical_statement {
public:
    canonical_statement(const statement& words, const known_names& names) : words_(words), names_(names) {}

    std::string text() const {
        std::string result;
        const bool keyword =
            is_keyword(words_, "variable") || is_keyword(words_, "exact") || is_invariant(words_) || is_event(words_);
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const bool spaced = is_symbol(words_[i], '=') || is_operator_of_sum(words_, i);
            const bool compares = i == 3 && is_history(words_);
            result += spaced ? " " + text_of_token(words_[i]) + " " : compares ? " <= " : text_of_token(words_[i]);
            if ((keyword && i == 0) || is_direction(words_, i + 1)) {
                result += " ";
            } else if (words_[i].kind == token_kind::numeral && i + 1 < words_.size() && is_operand(words_[i + 1])) {
                result += has_unit_behind(i) ? "" : "*";
            }
            const bool unknown = words_[i].kind == token_kind::name && names_.unknowns.contains(words_[i].text);
            i += unknown && has_variable_behind(words_, i, names_.variable) ? 3 : 0;
        }
        return result;
    }

private:
    bool has_unit_behind(std::size_t numeral) const {
        const std::string& name = words_[numeral + 1].text;
        return name == "deg" && !names_.parameters.contains(name);
    }

    const statement& words_;
    const known_names& names_;
};

}  // namespace

std::string canonical_text(std::string_view text) {
    const std::string variable = parse(text).variable;
    std::vector<statement> all = statements_of(text);
    const auto declared = declared_variable(all);
    with_primes(all, declared);
    const known_names names = names_in(all, variable);
    std::string result;
    for (const statement& words : all) {
        result += canonical_statement(words, names).text() + "\n";
    }
    const bool inferred = variable == "t" && inferred_variable(statements_of(result)) == variable;
    return declared || inferred ? result : "variable " + variable + "\n" + result;
}

}  // namespace libration::ode
