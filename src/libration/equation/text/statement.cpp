#include "statement.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "character.hpp"
#include "indexed_statement.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/number_lexer.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/utf8.hpp"

namespace libration::ode {

namespace {

bool begins_name(const character& c) {
    return c.kind == character_kind::letter ||
           (c.kind == character_kind::ascii && std::isalpha(static_cast<unsigned char>(c.source.front())) != 0);
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool goes_on_name(const character& c) {
    return begins_name(c) || c.kind == character_kind::subscript || c.source == "_" || is_digit(c.source.front());
}

// Longer ones first.
constexpr std::array<std::pair<std::string_view, char>, 11> condition_signs{{{"==", equal_sign},
                                                                             {"!=", unequal_sign},
                                                                             {"≠", unequal_sign},
                                                                             {"&&", and_sign},
                                                                             {"||", or_sign},
                                                                             {"&", and_sign},
                                                                             {"|", or_sign},
                                                                             {"!", not_sign},
                                                                             {"∧", and_sign},
                                                                             {"∨", or_sign},
                                                                             {"¬", not_sign}}};

constexpr std::array<std::pair<std::string_view, char>, 3> connectives{
    {{"and", and_sign}, {"or", or_sign}, {"not", not_sign}}};

// Reads the text from left to right.
class reader {
public:
    explicit reader(std::string_view text) : rest_(text) {}

    std::vector<statement> read() {
        while (!rest_.empty()) {
            const character c = first_character(rest_);
            if (c.source == "#") {
                advance(std::min(rest_.find('\n'), rest_.size()));
            } else if (c.source == ";" || c.source == "\n" || ends_at_comma()) {
                end_statement();
                advance(1);
            } else if (c.source == " " || c.source == "\t" || c.source == "\r" || c.kind == character_kind::blank) {
                advance(c.source.size());
                touches_ = false;
            } else if (c.kind == character_kind::superscript) {
                read_superscript();
            } else if (is_prime(c) && touches_ && !words_.empty() && is_symbol(words_.back(), ']')) {
                add_prime(c);
            } else {
                words_.push_back(word(c));
                open_ += change_of_depth(words_.back());
                touches_ = true;
            }
        }
        end_statement();
        return std::move(all_);
    }

private:
    void advance(std::size_t bytes) {
        const std::string_view passed = rest_.substr(0, bytes);
        if (passed == "\n") {
            at_ = {at_.line + 1, 1};
        } else {
            at_.column += static_cast<int>(characters_in(passed));
        }
        rest_.remove_prefix(bytes);
    }

    void end_statement() {
        if (!words_.empty()) {
            all_.push_back(std::move(words_));
            words_.clear();
        }
        open_ = 0;
        touches_ = false;
    }

    static bool is_prime(const character& c) { return c.source == "'" || c.kind == character_kind::prime; }

    // q[i]'
    void add_prime(const character& c) {
        token& bracket = words_.back();
        bracket.primes += static_cast<int>(c.ascii.size());
        bracket.source = {bracket.source.data(), bracket.source.size() + c.source.size()};
        advance(c.source.size());
    }

    token begun() const {
        token made;
        made.at = at_;
        made.touches = touches_;
        return made;
    }

    // Completes a token with the next bytes of the text as its source.
    void finish(token& made, std::size_t bytes) {
        made.source = rest_.substr(0, bytes);
        if (made.kind != token_kind::name) {
            made.text = made.source;
        }
        advance(bytes);
    }

    token word(const character& c) {
        token made = begun();
        if (begins_name(c)) {
            const std::size_t bytes = read_name(made);
            finish(made, bytes);
        } else if (c.kind == character_kind::word) {
            made.kind = token_kind::name;
            made.text = c.ascii;
            finish(made, c.source.size());
        } else if (is_digit(c.source.front()) || (c.source == "." && !rest_.starts_with(".."))) {
            finish(made, read_number(made));
        } else {
            finish(made, read_symbol(made, c));
        }
        return made;
    }

    std::size_t read_name(token& made) const {
        made.kind = token_kind::name;
        std::string_view tail = rest_;
        for (; !tail.empty() && goes_on_name(first_character(tail));
             tail.remove_prefix(first_character(tail).source.size())) {
            made.text += first_character(tail).ascii;
        }
        const std::size_t named = rest_.size() - tail.size();
        while (!tail.empty() && (tail.front() == '\'' || first_character(tail).kind == character_kind::prime)) {
            const character prime = first_character(tail);
            made.primes += static_cast<int>(prime.ascii.size());
            tail.remove_prefix(prime.source.size());
        }
        if (made.text.size() + static_cast<std::size_t>(made.primes) > longest_name) {
            refuse(std::string(rest_.substr(0, named)), at_,
                   "has more than " + std::to_string(longest_name) + " characters, including primes: choose another");
        }
        return rest_.size() - tail.size();
    }

    // 1 of 1..100
    std::size_t bytes_before_range() const {
        const std::size_t digits = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
        return rest_.substr(digits).starts_with("..") ? digits : rest_.size();
    }

    // Throws error for the operators of Fortran, .and. and .lt.
    void refuse_dotted_operator() const {
        static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> meant{
            {{".and.", "and"},
             {".or.", "or"},
             {".not.", "not"},
             {".lt.", "<"},
             {".le.", "<="},
             {".gt.", ">"},
             {".ge.", ">="},
             {".eq.", "=="},
             {".ne.", "!="},
             {".xor.", "(x > 1 and not (y > 2)) or (y > 2 and not (x > 1))"}}};
        const std::string_view written = rest_.substr(0, rest_.find('.', 1) + 1);
        for (const auto& [dotted, sign] : meant) {
            if (std::ranges::equal(written, dotted, {}, [](unsigned char c) { return std::tolower(c); })) {
                refuse(std::string(written), at_, "is not an operator: write " + std::string(sign));
            }
        }
    }

    std::size_t read_number(token& made) const {
        std::string_view tail = rest_.substr(0, bytes_before_range());
        const std::size_t bytes = tail.size();
        try {
            const auto number = take_number(tail);
            if (!number) {
                refuse_dotted_operator();
                refuse(".", at_, "is not a number: write digits");
            }
            made.kind = token_kind::numeral;
            made.value = number->value();
        } catch (const error& problem) {
            if (!problem.is_about(error_subject::number)) {
                throw;
            }
            refuse(std::string(rest_.substr(0, 20)), at_, problem.reason() + ": choose another number");
        }
        return bytes - tail.size();
    }

    // Of x²⁻¹ it is not known whether the exponents are added or multiplied.
    void require_one_exponent() const {
        if (words_.empty() || !words_.back().raised) {
            return;
        }
        const auto last = std::ranges::find_if(words_.rbegin(), words_.rend(),
                                               [](const token& word) { return word.raised && word.symbol == '^'; });
        std::string_view tail = rest_;
        while (!tail.empty() && first_character(tail).kind == character_kind::superscript) {
            tail.remove_prefix(first_character(tail).source.size());
        }
        refuse({last->source.data(), tail.data()}, last->at,
               "has a second exponent behind a superscript: write one in parentheses, as in x^(2-1)");
    }

    // x² and x⁻¹ as x^2 and x^-1.
    void read_superscript() {
        require_one_exponent();
        token power = begun();
        power.symbol = '^';
        power.raised = true;
        power.source = rest_.substr(0, 0);
        power.touches = true;
        words_.push_back(power);
        const character first = first_character(rest_);
        if (!is_digit(first.ascii.front())) {
            token sign = power;
            sign.symbol = first.ascii.front();
            finish(sign, first.source.size());
            words_.push_back(sign);
        }
        token exponent = begun();
        exponent.kind = token_kind::numeral;
        exponent.raised = true;
        std::string digits;
        std::string_view tail = rest_;
        while (!tail.empty() && first_character(tail).kind == character_kind::superscript &&
               is_digit(first_character(tail).ascii.front())) {
            digits += first_character(tail).ascii;
            tail.remove_prefix(first_character(tail).source.size());
        }
        std::string_view unread = digits;
        const auto number = take_number(unread);
        if (!number) {
            refuse(std::string(first.source), power.at, "is not an exponent: write digits, as in x^2");
        }
        exponent.value = number->value();
        finish(exponent, rest_.size() - tail.size());
        words_.push_back(exponent);
        touches_ = true;
    }

    // A comma outside parentheses separates statements; inside, the arguments of a function or the ends of an interval.
    bool ends_at_comma() const {
        if (rest_.front() != ',' || open_ > 0) {
            return false;
        }
        const bool in_number = touches_ && !words_.empty() && words_.back().kind == token_kind::numeral &&
                               rest_.size() > 1 && is_digit(rest_[1]);
        if (in_number) {
            std::string_view tail = rest_.substr(1);
            const std::string digits(tail.substr(0, tail.find_first_not_of("0123456789")));
            const std::string before(words_.back().source);
            refuse(before + "," + digits, words_.back().at,
                   "is ambiguous: write " + before + "." + digits +
                       " for a decimal, or a blank after a comma between "
                       "statements");
        }
        return true;
    }

    std::size_t read_symbol(token& made, const character& c) const {
        if (rest_.starts_with("**")) {
            made.symbol = '^';
            return 2;
        }
        if (rest_.starts_with("..")) {
            made.symbol = range_sign;
            return 2;
        }
        if (rest_.starts_with("<>")) {
            refuse("<>", at_, "is not a comparison: write x != 1 for x <> 1");
        }
        if (rest_.starts_with("<=") || rest_.starts_with(">=")) {
            made.symbol = c.source.front();
            made.or_equal = true;
            return 2;
        }
        for (const auto& [written, symbol] : condition_signs) {
            if (rest_.starts_with(written)) {
                made.symbol = symbol;
                return written.size();
            }
        }
        if (const std::size_t bytes = bytes_of_interval_sign(c)) {
            made.symbol = interval_sign;
            return bytes;
        }
        if (c.kind == character_kind::symbol || (c.kind == character_kind::ascii && is_allowed(c.source.front()))) {
            made.symbol = c.ascii.front();
            made.or_equal = c.kind == character_kind::symbol && (made.symbol == '<' || made.symbol == '>');
            return c.source.size();
        }
        refuse_symbol(c);
    }

    static bool is_allowed(char c) { return std::string_view("()[]+-*/^=,:<>").find(c) != std::string_view::npos; }

    // Of +- and -+, also of other characters for a minus; 0 if the text does not begin with one.
    std::size_t bytes_of_interval_sign(const character& c) const {
        if (const auto sign = interval_sign_at(rest_)) {
            return sign->size();
        }
        if ((c.ascii == "+" || c.ascii == "-") && rest_.size() > c.source.size()) {
            const character next = first_character(rest_.substr(c.source.size()));
            if ((next.ascii == "+" || next.ascii == "-") && next.ascii != c.ascii &&
                next.kind != character_kind::superscript) {
                return c.source.size() + next.source.size();
            }
        }
        return 0;
    }

    [[noreturn]] void refuse_symbol(const character& c) const {
        const std::string shown = is_printable(c.source) ? std::string(c.source) : "\\?";
        if (c.kind == character_kind::prime || c.source == "'") {
            refuse(shown, at_, "does not follow a name: write primes directly after an unknown, as f''");
        }
        switch (c.source.front()) {
            case '~':
                if (rest_.starts_with("~=")) {
                    refuse("~=", at_, "is not a comparison: write x != 1 for x ~= 1");
                }
                refuse(shown, at_, "is not an operator: write not (t > 1) for ~(t > 1)");
            case '%': refuse(shown, at_, "is not an operator: write mod(t, 2) for t % 2");
            case '?': refuse(shown, at_, "is not an operator: write if(t > 1, 1, 0) for t > 1 ? 1 : 0");
            case '{': refuse(shown, at_, "is not a parenthesis here: write (");
            default: refuse(shown, at_, "is not allowed in a problem: write names, numbers, + - * / ^ ( ) = and ;");
        }
    }

    std::string_view rest_;
    place at_{1, 1};
    bool touches_ = false;
    long open_ = 0;  // parentheses and brackets of the statement
    statement words_;
    std::vector<statement> all_;
};

// Replaces the names `and`, `or` and `not` by their symbols, unless they are names of an unknown or a parameter.
void read_connectives(std::vector<statement>& all) {
    for (const auto& [name, symbol] : connectives) {
        const auto is_name = [&](const token& word) { return word.kind == token_kind::name && word.text == name; };
        const bool defined = std::ranges::any_of(all, [&](const statement& words) {
            return is_name(words.front()) ||
                   std::ranges::any_of(words, [&](const token& word) { return is_name(word) && word.primes > 0; });
        });
        for (statement& words : all) {
            for (token& word : words) {
                if (!defined && is_name(word)) {
                    word.kind = token_kind::symbol;
                    word.symbol = symbol;
                }
            }
        }
    }
}

}  // namespace

std::vector<statement> statements_of(std::string_view text) {
    if (text.size() > longest_problem) {
        refuse("", {}, "is longer than " + std::to_string(longest_problem) + " characters: write less");
    }
    std::vector<statement> all = reader(text).read();
    read_connectives(all);
    write_out_indices(all);
    return all;
}

bool is_symbol(const token& word, char c) { return word.kind == token_kind::symbol && word.symbol == c; }

bool is_comparison(const token& word) {
    return is_symbol(word, '<') || is_symbol(word, '>') || is_symbol(word, equal_sign) || is_symbol(word, unequal_sign);
}

bool is_connective(const token& word) {
    return is_symbol(word, and_sign) || is_symbol(word, or_sign) || is_symbol(word, not_sign);
}

bool symbol_at(const statement& words, std::size_t index, char c) {
    return index < words.size() && is_symbol(words[index], c);
}

std::size_t equals_of(const statement& words) {
    const auto is_equals = [](const token& word) { return is_symbol(word, '='); };
    const auto comparison = std::ranges::find_if(words, is_comparison);
    if (comparison != words.end() && std::ranges::none_of(words, is_equals)) {
        refuse(std::string(comparison->source), comparison->at, "is not an equation: write =");
    }
    const auto found = std::ranges::find_if(words, is_equals);
    if (found == words.end()) {
        refuse(whole(words), words.front().at, "is not an equation: write one with =");
    }
    int open = 0;
    for (const token& word : words) {
        open += change_of_depth(word);
        if (open > 0 && is_equals(word)) {
            refuse("=", word.at, "is not a comparison: write == in a condition");
        }
    }
    if (std::ranges::count_if(words, is_equals) > 1) {
        refuse(whole(words), words.front().at, "has more than one =: write separate statements");
    }
    const auto place = static_cast<std::size_t>(found - words.begin());
    if (place == 0 || place + 1 == words.size()) {
        refuse(whole(words), found->at, "has nothing on one side of =: write both sides");
    }
    return place;
}

bool is_keyword(const statement& words, std::string_view name) {
    return words.size() > 1 && words[0].kind == token_kind::name && words[0].primes == 0 && words[0].text == name &&
           words[1].kind != token_kind::symbol;
}

bool is_invariant(const statement& words) {
    const bool named =
        words.size() > 1 && words[0].kind == token_kind::name && words[0].primes == 0 && words[0].text == "invariant";
    return named && std::ranges::none_of(words, [](const token& word) { return is_symbol(word, '='); });
}

}  // namespace libration::ode
