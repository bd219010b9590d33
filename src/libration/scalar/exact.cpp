#include "libration/scalar/exact.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/scalar/text/expression_text.hpp"
#include "libration/scalar/text/number_lexer.hpp"

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

// [sign] number [unit] [/ number]; nothing for any other text.
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
            throw error(error_kind::argument, "number", "", "divides by zero");
        }
        value /= divisor->value();
    }
    if (!rest.empty()) {
        return std::nullopt;
    }
    return exact{negative ? rational(-value) : value, measure, std::string(text)};
}

exact formula_of(const expression& value, std::string text) {
    if (auto number = value.plain()) {
        return {std::move(number->coefficient), number->measure, std::move(text), nullptr, true};
    }
    return {0, unit::expression, std::move(text), std::make_shared<const expression>(value), true};
}

// A text in parentheses where it is no single number.
std::string operand(const exact& number) {
    const bool single = number.text.find_first_of("+-*/^ ") == std::string::npos;
    return single ? number.text : "(" + number.text + ")";
}

}  // namespace

rational exact::in_pi() const {
    if (!is_angle() && !is_zero()) {
        throw std::logic_error(text + " is no fraction of pi");
    }
    return measure == unit::degree ? rational(coefficient / 180) : coefficient;
}

bool exact::is_number() const { return is_fraction() || (measure == unit::expression && !has_periods()); }

rational exact::periods() const {
    return measure == unit::period ? coefficient : formula ? formula->periods() : rational(0);
}

exact exact::without_periods() const {
    if (measure == unit::period) {
        return {};
    }
    return formula ? exactly(formula->without_periods(), text) : *this;
}

expression as_expression(const exact& number) {
    return number.formula ? *number.formula : expression(number.coefficient, number.measure);
}

exact exactly(const expression& value, std::string text) { return formula_of(value, std::move(text)); }

exact read_exact(std::string_view text) {
    try {
        if (text.empty()) {
            throw error(error_kind::argument, "number", "", "is empty");
        }
        if (auto plain = read_plain(text)) {
            return *std::move(plain);
        }
        return formula_of(read_expression(text), std::string(text));
    } catch (const error& problem) {
        throw error(problem.kind(), "number", std::string(text), problem.reason());
    }
}

exact operator+(const exact& a, const exact& b) {
    return exactly(as_expression(a) + as_expression(b), operand(a) + "+" + operand(b));
}
exact operator-(const exact& a, const exact& b) {
    return exactly(as_expression(a) - as_expression(b), operand(a) + "-" + operand(b));
}
exact operator*(const exact& a, const exact& b) {
    return exactly(as_expression(a) * as_expression(b), operand(a) + "*" + operand(b));
}
exact operator/(const exact& a, const exact& b) {
    return exactly(as_expression(a) / as_expression(b), operand(a) + "/" + operand(b));
}

int sign_of_exact(const exact& number) {
    if (number.measure != unit::expression) {
        return number.coefficient.sign();
    }
    try {
        return number.formula->sign();
    } catch (const error& problem) {
        throw error(problem.kind(), "number", number.text, problem.reason());
    }
}

mpfr mpfr_from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<mpfr>(number.coefficient);
        case unit::period: throw std::domain_error(number.text + " is a multiple of a period, not a number");
        case unit::expression: break;
        default: return from_rational<mpfr>(number.in_pi()) * pi<mpfr>();
    }
    if (number.has_periods()) {
        throw std::domain_error(number.text + " is a multiple of a period, not a number");
    }
    try {
        return rounded_value(*number.formula);
    } catch (const error& problem) {
        throw error(problem.kind(), "number", number.text, problem.reason());
    }
}

}  // namespace libration
