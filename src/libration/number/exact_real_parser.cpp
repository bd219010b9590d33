#include <cctype>
#include <cstddef>
#include <string>

#include "libration/number/exact_real_text.hpp"
#include "libration/number/number_lexer.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

constexpr std::size_t longest_text = 100'000;
constexpr int deepest = 100;

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// By recursive descent, of bounded depth: sum, product, factor (a sign), power, primary.
class expression_parser {
public:
    explicit expression_parser(std::string_view text) : text_(text), rest_(text) {}

    exact_real read() {
        if (text_.size() > longest_text) {
            refuse("is longer than " + std::to_string(longest_text) + " characters");
        }
        exact_real value = sum();
        if (!rest_.empty()) {
            refuse_here(rest_.front() == ')' ? "has an unmatched )" : "");
        }
        return value;
    }

private:
    [[noreturn]] static void refuse(const std::string& reason) {
        throw error(error_kind::argument, error_subject::number, "", reason);
    }

    std::string column_of(std::string_view place) const {
        return " at column " + std::to_string(text_.size() - place.size() + 1);
    }

    // At an operator.
    void refuse_interval() {
        const std::string_view before = rest_;
        skip_blanks();
        if (const auto sign = interval_sign_at(rest_)) {
            refuse("has a " + std::string(*sign) + column_of(rest_) + ", which " + interval_reason);
        }
        rest_ = before;
    }

    // A text that is not a formula at all is reported as not a number; within a formula, the position is reported.
    [[noreturn]] void refuse_here(const std::string& what = "") const {
        if (text_.find_first_of("()*^") == std::string_view::npos) {
            refuse("is not a number");
        }
        if (rest_.empty()) {
            refuse("does not end: a number is missing");
        }
        const char c = rest_.front();
        const bool printable = c > ' ' && c < '\x7f';
        refuse(
            (what.empty() ? printable ? std::string("has an unexpected ") + c : "has an unexpected character" : what) +
            column_of(rest_));
    }

    void skip_blanks() {
        while (rest_.starts_with(' ')) {
            rest_.remove_prefix(1);
        }
    }

    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) {
            return false;
        }
        rest_.remove_prefix(word.size());
        return true;
    }

    // An operator with blanks on both sides; a blank not followed by it is left.
    bool take_operator(std::string_view word) {
        const std::string_view before = rest_;
        skip_blanks();
        if (take(word)) {
            skip_blanks();
            return true;
        }
        rest_ = before;
        return false;
    }

    bool take_sign() {
        const bool negative = take("-");
        if (negative || take("+")) {
            skip_blanks();
        }
        return negative;
    }

    // A parenthesis or an exponent, of which each is one level.
    void enter() {
        if (++depth_ > deepest) {
            refuse("is nested more than " + std::to_string(deepest) + " deep");
        }
    }

    exact_real sum() {
        const bool negative = take_sign();
        exact_real total = negative ? -product() : product();
        for (;;) {
            refuse_interval();
            if (take_operator("+")) {
                total = total + product();
            } else if (take_operator("-")) {
                total = total - product();
            } else {
                return total;
            }
        }
    }

    exact_real product() {
        exact_real value = factor();
        for (;;) {
            if (take_operator("*")) {
                value = value * factor();
            } else if (take_operator("/")) {
                const std::string_view before = rest_;
                const exact_real divisor = factor();
                if (juxtaposed_) {
                    rest_ = before;
                    refuse("is ambiguous" + column_of(before) + ": write parentheses, as 1/(2*pi) or (1/2)*pi");
                }
                value = value / divisor;
            } else {
                return value;
            }
        }
    }

    // primary [^ exponent]; for a number before pi, deg or T the exponent applies to the symbol after the number.
    exact_real factor() {
        juxtaposed_ = false;
        if (const auto number = take_number(rest_)) {
            const exact_real value(number->value());
            if (auto behind = unit_behind_number()) {
                const exact_real raised = power_of(*behind);
                juxtaposed_ = true;
                return value * raised;
            }
            return power_of(value);
        }
        const exact_real value = primary();
        exact_real raised = power_of(value);
        juxtaposed_ = false;
        return raised;
    }

    std::optional<exact_real> unit_behind_number() {
        if (rest_.empty() || !starts_name(rest_.front())) {
            return std::nullopt;
        }
        const std::string_view before = rest_;
        const std::string_view name = take_name();
        if (name == "deg") {
            return exact_real(1, unit::degree);
        }
        if (auto value = constant(name)) {
            return value;
        }
        rest_ = before;
        refuse_here("has '" + std::string(name) + "' directly after a number (write *)");
    }

    exact_real power_of(const exact_real& base) {
        if (!take_operator("^") && !take_operator("**")) {
            return base;
        }
        enter();
        const bool negative = take_sign();
        const exact_real exponent = factor();
        --depth_;
        return power(base, negative ? -exponent : exponent);
    }

    std::string_view take_name() {
        std::size_t length = 0;
        while (length < rest_.size() && continues_name(rest_[length])) {
            ++length;
        }
        const std::string_view name = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return name;
    }

    static std::optional<exact_real> constant(std::string_view name) {
        if (name == "pi") {
            return exact_real(1, unit::pi);
        }
        return name == "T" ? std::optional(exact_real(1, unit::period)) : std::nullopt;
    }

    exact_real primary() {
        if (take("(")) {
            return in_parentheses();
        }
        if (rest_.empty() || !starts_name(rest_.front())) {
            refuse_here();
        }
        const std::string_view before = rest_;
        const std::string_view name = take_name();
        if (const auto value = constant(name)) {
            return *value;
        }
        const auto f = function_named(name);
        if (!f) {
            refuse_name(name, before);
        }
        if (!take_operator("(")) {
            refuse("has " + std::string(name) + " without a ( after it" + column_of(before));
        }
        if (!has_order(*f)) {
            return apply(*f, in_parentheses());
        }
        const auto order = before_end().fraction();
        if (!order) {
            refuse("has " + std::string(name) + " with an order that is not a fraction" + column_of(before));
        }
        if (!take(",")) {
            refuse("has " + std::string(name) + " without an order: write " + std::string(name) + "(0, 1)" +
                   column_of(before));
        }
        return apply(*f, *order, in_parentheses());
    }

    // A text that is a single word is not a formula.
    [[noreturn]] void refuse_name(std::string_view name, std::string_view place) const {
        std::string_view word = text_;
        word.remove_prefix(word.starts_with('-') || word.starts_with('+') ? 1 : 0);
        if (word == name) {
            refuse("is not a number");
        }
        constexpr std::size_t shown = 30;
        refuse("has an unknown name \"" + std::string(name.substr(0, shown)) + (name.size() > shown ? "..." : "") +
               "\"" + column_of(place));
    }

    exact_real before_end() {
        skip_blanks();
        enter();
        exact_real value = sum();
        --depth_;
        skip_blanks();
        if (rest_.empty()) {
            refuse("does not end: a ) is missing");
        }
        return value;
    }

    exact_real in_parentheses() {
        exact_real value = before_end();
        if (!take(")")) {
            refuse_here();
        }
        return value;
    }

    std::string_view text_;
    std::string_view rest_;
    int depth_ = 0;
    bool juxtaposed_ = false;  // whether the last factor was a number directly before pi, deg or T
};

}  // namespace

exact_real read_expression(std::string_view text) { return expression_parser(text).read(); }

}  // namespace libration
