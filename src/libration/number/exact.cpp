#include "libration/number/exact.hpp"

#include <stdexcept>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration {

namespace {

// A text, in parentheses unless it is a single number.
std::string operand(const exact& number) {
    const bool single = number.text.find_first_of("+-*/^ ") == std::string::npos;
    return single ? number.text : "(" + number.text + ")";
}

}  // namespace

rational exact::in_pi() const {
    if (!is_angle() && !is_zero()) {
        throw std::logic_error(text + " is not a fraction of pi");
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

exact_real as_exact_real(const exact& number) {
    return number.formula ? *number.formula : exact_real(number.coefficient, number.measure);
}

exact exactly(const exact_real& value, std::string text) {
    if (auto number = value.plain()) {
        return {std::move(number->coefficient), number->measure, std::move(text), nullptr, true};
    }
    return {0, unit::expression, std::move(text), std::make_shared<const exact_real>(value), true};
}

exact operator+(const exact& a, const exact& b) {
    return exactly(as_exact_real(a) + as_exact_real(b), operand(a) + "+" + operand(b));
}
exact operator-(const exact& a, const exact& b) {
    return exactly(as_exact_real(a) - as_exact_real(b), operand(a) + "-" + operand(b));
}
exact operator*(const exact& a, const exact& b) {
    return exactly(as_exact_real(a) * as_exact_real(b), operand(a) + "*" + operand(b));
}
exact operator/(const exact& a, const exact& b) {
    return exactly(as_exact_real(a) / as_exact_real(b), operand(a) + "/" + operand(b));
}

int sign_of_exact(const exact& number) {
    if (number.measure != unit::expression) {
        return number.coefficient.sign();
    }
    try {
        return number.formula->sign();
    } catch (const error& problem) {
        throw error(problem.kind(), error_subject::number, number.text, problem.reason());
    }
}

mpfr mpfr_from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<mpfr>(number.coefficient);
        case unit::period:
            throw error(error_kind::argument, error_subject::number, number.text,
                        "is a multiple of a period, not a number");
        case unit::expression: break;
        case unit::pi:
        case unit::degree: return from_rational<mpfr>(number.in_pi()) * pi<mpfr>();
    }
    if (number.has_periods()) {
        throw error(error_kind::argument, error_subject::number, number.text,
                    "is a multiple of a period, not a number");
    }
    try {
        return rounded_value(*number.formula);
    } catch (const error& problem) {
        throw error(problem.kind(), error_subject::number, number.text, problem.reason());
    }
}

}  // namespace libration
