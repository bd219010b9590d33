#include "libration/problem/axis.hpp"
#include "libration/scalar/error.hpp"

#include <algorithm>
#include <cctype>

#include "libration/scalar/decimal.hpp"

namespace libration {

namespace {

// Digits, with at most a point among them and an exponent after them: a text that is kept unchanged.
bool is_plain_decimal(std::string_view text) {
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    text.remove_prefix(text.starts_with('-') ? 1 : 0);
    const auto e = std::min(text.find('e'), text.size());
    const std::string_view significand = text.substr(0, e);
    std::string_view exponent = text.substr(e);
    exponent.remove_prefix(exponent.starts_with("e-") ? 2 : exponent.empty() ? 0 : 1);
    return !significand.empty() && digit(significand.front()) && digit(significand.back()) &&
           std::count(significand.begin(), significand.end(), '.') <= 1 &&
           std::all_of(significand.begin(), significand.end(), [&](char c) { return c == '.' || digit(c); }) &&
           (e == text.size() || (!exponent.empty() && std::all_of(exponent.begin(), exponent.end(), digit)));
}

}  // namespace

exact axis::coordinate_of(const exact& value) const { return to_coordinate ? to_coordinate(value) : value; }

const std::vector<exact>& axis_values::of(const std::string& name) const {
    static const std::vector<exact> nothing;
    const auto found = all_.find(name);
    return found != all_.end() ? found->second : nothing;
}

std::vector<integer> axis_values::whole(const std::string& name) const {
    std::vector<integer> result;
    for (const exact& value : of(name)) {
        result.push_back(numerator(value.coefficient));
    }
    return result;
}

std::vector<int> axis_values::counts(const std::string& name) const {
    std::vector<int> result;
    for (const exact& value : of(name)) {
        result.push_back(numerator(value.coefficient).convert_to<int>());
    }
    return result;
}

void require_plain_number(const exact& value) {
    if (value.measure != unit::one) {
        throw error(error_kind::argument, "value", "",
                    "has '" + value.text + "', which is not a decimal or a fraction");
    }
}

std::string decimal_of(const exact& value, long digits) {
    const bool plain = value.measure == unit::one;
    if (plain && is_plain_decimal(value.text)) {
        return value.text;
    }
    if (plain || value.is_zero()) {
        return decimal_of(value.coefficient, digits);
    }
    const precision_scope scope(digits + 10);
    return to_decimal(from_exact<mpfr>(value), digits);
}

std::string decimal_of(const rational& value, long digits) {
    if (const auto finite = to_finite_decimal(value)) {
        return *finite;
    }
    const precision_scope scope(digits + 10);
    return to_decimal(from_rational<mpfr>(value), digits);
}

}  // namespace libration
