// Exact numbers from text: plain ones, and formulas.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "libration/number/exact.hpp"
#include "libration/number/exact_real_text.hpp"
#include "libration/number/number_lexer.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

bool take(std::string_view& rest, std::string_view word) {
    if (!rest.starts_with(word)) {
        return false;
    }
    rest.remove_prefix(word.size());
    return true;
}

unit take_unit(std::string_view& rest) {
    if (take(rest, "pi")) {
        return unit::pi;
    }
    if (take(rest, "deg")) {
        return unit::degree;
    }
    return take(rest, "T") ? unit::period : unit::one;
}

// [sign] number [unit] [/ number]; std::nullopt for any other text.
std::optional<exact> read_plain(std::string_view text) {
    std::string_view rest = text;
    const bool negative = take(rest, "-");
    if (!negative) {
        take(rest, "+");
    }
    const bool bare_unit = rest.starts_with("pi") || rest.starts_with("T");
    const auto number = bare_unit ? std::nullopt : take_number(rest);
    if (!bare_unit && !number) {
        return std::nullopt;
    }
    rational value = bare_unit ? rational(1) : number->value();
    const unit measure = take_unit(rest);
    if (take(rest, "/")) {
        const auto divisor = take_number(rest);
        if (!divisor || !rest.empty()) {
            return std::nullopt;
        }
        if (divisor->significand == 0) {
            throw error(error_kind::argument, error_subject::number, "", "divides by zero");
        }
        value /= divisor->value();
    }
    if (!rest.empty()) {
        return std::nullopt;
    }
    return exact{negative ? rational(-value) : value, measure, std::string(text)};
}

}  // namespace

exact read_exact(std::string_view text) {
    try {
        if (text.empty()) {
            throw error(error_kind::argument, error_subject::number, "", "is empty");
        }
        if (auto plain = read_plain(text)) {
            return *std::move(plain);
        }
        return exactly(read_expression(text), std::string(text));
    } catch (const error& problem) {
        throw error(problem.kind(), error_subject::number, std::string(text), problem.reason());
    }
}

}  // namespace libration
