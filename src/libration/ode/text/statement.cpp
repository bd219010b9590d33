#include "statement.hpp"

#include <algorithm>
#include <cctype>

#include "libration/ode/parse.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/number_lexer.hpp"

namespace libration::ode {

namespace {

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool goes_on_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Reads the text from left to right.
class reader {
public:
    explicit reader(std::string_view text) : rest_(text) {}

    std::vector<statement> read() {
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '#') {
                advance(std::min(rest_.find('\n'), rest_.size()));
            } else if (c == ';' || c == '\n') {
                end_statement();
                advance(1);
            } else if (c == ' ' || c == '\t' || c == '\r') {
                advance(1);
                touches_ = false;
            } else {
                words_.push_back(word());
                touches_ = true;
            }
        }
        end_statement();
        return std::move(all_);
    }

private:
    void advance(std::size_t count) {
        for (const char c : rest_.substr(0, count)) {
            if (c == '\n') {
                at_ = {at_.line + 1, 1};
            } else {
                ++at_.column;
            }
        }
        rest_.remove_prefix(count);
    }

    void end_statement() {
        if (!words_.empty()) {
            all_.push_back(std::move(words_));
            words_.clear();
        }
        touches_ = false;
    }

    token word() {
        const char c = rest_.front();
        token made;
        made.at = at_;
        made.touches = touches_;
        std::size_t length = 1;
        if (begins_name(c)) {
            made.kind = token_kind::name;
            length = name_length();
            for (; length + static_cast<std::size_t>(made.primes) < rest_.size() &&
                   rest_[length + static_cast<std::size_t>(made.primes)] == '\'';
                 ++made.primes) {
            }
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') {
            length = read_number(made);
        } else {
            length = read_symbol(made);
        }
        if (made.kind == token_kind::name && length + static_cast<std::size_t>(made.primes) > longest_name) {
            refuse(std::string(rest_.substr(0, length)), at_,
                   "has more than " + std::to_string(longest_name) + " characters, including primes: choose another");
        }
        made.text = rest_.substr(0, length);
        advance(length + static_cast<std::size_t>(made.primes));
        return made;
    }

    std::size_t name_length() const {
        std::size_t length = 0;
        while (length < rest_.size() && goes_on_name(rest_[length])) {
            ++length;
        }
        return length;
    }

    std::size_t read_number(token& made) const {
        std::string_view tail = rest_;
        try {
            const auto number = take_number(tail);
            if (!number) {
                refuse(".", at_, "is not a number: write digits");
            }
            made.kind = token_kind::numeral;
            made.value = number->value();
        } catch (const error& problem) {
            if (problem.subject() != "number") {
                throw;
            }
            refuse(std::string(rest_.substr(0, 20)), at_, problem.reason() + ": choose another number");
        }
        return rest_.size() - tail.size();
    }

    // Whether a comma separates the arguments of a function here.
    bool in_parentheses() const {
        const auto count = [this](char c) { return std::ranges::count(words_, c, &token::symbol); };
        return count('(') > count(')');
    }

    std::size_t read_symbol(token& made) const {
        const char c = rest_.front();
        if (rest_.starts_with("**")) {
            made.symbol = '^';
            return 2;
        }
        if (const auto sign = interval_sign_at(rest_)) {
            refuse(std::string(*sign), at_, interval_reason);
        }
        made.symbol = c;
        if (std::string_view("()+-*/^=").find(c) != std::string_view::npos || (c == ',' && in_parentheses())) {
            return 1;
        }
        const std::string shown = c > ' ' && c < '\x7f' ? std::string(1, c) : std::string("\\") + "?";
        switch (c) {
            case ',': refuse(shown, at_, "is not expected: write a decimal point, and ; between statements");
            case '\'': refuse(shown, at_, "does not follow a name: write primes directly after an unknown, as f''");
            case '[':
            case '{': refuse(shown, at_, "is not a parenthesis here: write (");
            case '<':
            case '>': refuse(shown, at_, "is not an equation: write =");
            default: refuse(shown, at_, "is not allowed in a problem: write names, numbers, + - * / ^ ( ) = and ;");
        }
    }

    std::string_view rest_;
    place at_{1, 1};
    bool touches_ = false;
    statement words_;
    std::vector<statement> all_;
};

}  // namespace

std::vector<statement> statements_of(std::string_view text) {
    if (text.size() > longest_problem) {
        refuse("", {}, "is longer than " + std::to_string(longest_problem) + " characters: write less");
    }
    return reader(text).read();
}

std::string text_of(const statement& words, std::size_t first, std::size_t last) {
    if (first >= last) {
        return "";
    }
    const std::string_view from = words[first].text;
    const token& end = words[last - 1];
    return {from.data(), end.text.data() + end.text.size() + end.primes};
}

}  // namespace libration::ode
