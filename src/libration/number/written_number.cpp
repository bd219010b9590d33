#include "libration/number/written_number.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "libration/number/number_lexer.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

bool is_hexadecimal(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    return text.starts_with("0x") || text.starts_with("0X");
}

rational power_of(int base, long exponent) {
    const integer power = boost::multiprecision::pow(integer(base), static_cast<unsigned>(std::labs(exponent)));
    return exponent < 0 ? rational(integer(1), power) : rational(power);
}

written_number read_written(std::string_view text) {
    const bool hexadecimal = is_hexadecimal(text);
    std::string_view rest = text;
    const bool negative = rest.starts_with('-');
    rest.remove_prefix(negative || rest.starts_with('+') ? 1 : 0);
    rest.remove_prefix(hexadecimal ? 2 : 0);
    const auto number = take_number(rest, hexadecimal ? radix::hexadecimal : radix::decimal);
    if (!number || !rest.empty()) {
        throw error(error_kind::argument, error_subject::number, std::string(text), "is not a number");
    }
    const rational value = number->value();
    return {negative ? rational(-value) : value, number->last_place()};
}

exact read_typed(std::string_view text) {
    return is_hexadecimal(text) ? exact{read_written(text).value, unit::one, std::string(text)} : read_exact(text);
}

rational nearest_double(const rational& q) {
    if (q == 0) {
        return q;
    }
    const double below = mpq_get_d(q.backend().data());  // towards 0
    const double above = std::nextafter(below, q.sign() * std::numeric_limits<double>::infinity());
    if (!std::isfinite(above)) {
        throw error(error_kind::argument, error_subject::number, "", "is beyond the largest double");
    }
    const rational lower(below);
    const rational upper(above);
    const rational from_lower = abs(rational(q - lower));
    const rational from_upper = abs(rational(upper - q));
    const bool even = std::bit_cast<std::uint64_t>(below) % 2 == 0;
    return from_lower < from_upper || (from_lower == from_upper && even) ? lower : upper;
}

exact nearest_double(const exact& number) {
    if (number.measure == unit::one) {
        return {nearest_double(number.coefficient), unit::one, number.text};
    }
    const auto radians = from_exact<double>(number);
    if (!std::isfinite(radians)) {
        throw error(error_kind::argument, error_subject::number, "", "is beyond the largest double");
    }
    return {rational(radians), unit::one, number.text};
}

rational unit_in_last_place(const rational& q) {
    constexpr long least = DBL_MIN_EXP - DBL_MANT_DIG;
    if (q == 0) {
        return power_of(2, least);
    }
    const rational size = abs(q);
    const long below = static_cast<long>(msb(numerator(size))) - static_cast<long>(msb(denominator(size)));
    const long exponent = power_of(2, below) <= size ? below + 1 : below;
    return power_of(2, std::max(exponent - DBL_MANT_DIG, least));
}

}  // namespace libration
