#include "libration/number/number_lexer.hpp"

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "libration/scalar/error.hpp"

namespace libration {

namespace {

constexpr long largest_scale = 100'000;
constexpr std::size_t most_significant_digits = 200'000;

[[noreturn]] void refuse_scale() {
    throw error(error_kind::argument, error_subject::number, "", "is beyond the range 1e-100000 .. 1e100000");
}

bool is_digit(char c, radix base) {
    const auto byte = static_cast<unsigned char>(c);
    return (base == radix::decimal ? std::isdigit(byte) : std::isxdigit(byte)) != 0;
}

std::string_view take_digits(std::string_view& rest, radix base) {
    std::size_t length = 0;
    while (length < rest.size() && is_digit(rest[length], base)) {
        ++length;
    }
    const std::string_view digits = rest.substr(0, length);
    rest.remove_prefix(length);
    return digits;
}

// The value of e[sign]digits, if it is at the front; 0 otherwise.
long take_exponent(std::string_view& rest, radix base) {
    const char letter = base == radix::decimal ? 'e' : 'p';
    if (rest.empty() || std::tolower(static_cast<unsigned char>(rest.front())) != letter) {
        return 0;
    }
    std::string_view tail = rest.substr(1);
    const bool negative = tail.starts_with('-');
    tail.remove_prefix(negative || tail.starts_with('+') ? 1 : 0);
    const std::string_view digits = take_digits(tail, radix::decimal);
    if (digits.empty()) {
        return 0;
    }
    rest = tail;
    long value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc() || value > 2 * largest_scale) {
        refuse_scale();
    }
    return negative ? -value : value;
}

rational power_of_base(radix base, long scale) {
    const auto size = static_cast<unsigned>(std::labs(scale));
    const integer power = base == radix::decimal ? boost::multiprecision::pow(integer(10), size) : integer(1) << size;
    return scale < 0 ? rational(integer(1), power) : rational(power);
}

}  // namespace

rational lexed_number::value() const {
    if (significand == 0) {
        return 0;
    }
    const auto size = static_cast<unsigned>(std::labs(scale));
    const integer power = base == radix::decimal ? boost::multiprecision::pow(integer(10), size) : integer(1) << size;
    return scale < 0 ? rational(significand, power) : rational(integer(significand * power));
}

rational lexed_number::last_place() const { return power_of_base(base, scale); }

std::optional<lexed_number> take_number(std::string_view& rest, radix base) {
    std::string_view tail = rest;
    std::string digits(take_digits(tail, base));
    long places = 0;
    if (tail.starts_with('.')) {
        tail.remove_prefix(1);
        const std::string_view fraction = take_digits(tail, base);
        digits += fraction;
        places = static_cast<long>(fraction.size());
    }
    if (digits.empty()) {
        return std::nullopt;
    }
    const long exponent = take_exponent(tail, base);
    const long scale = exponent - (base == radix::decimal ? places : 4 * places);
    if (std::labs(scale) > largest_scale || digits.size() > most_significant_digits) {
        refuse_scale();
    }
    rest = tail;
    // A leading 0 would mean octal.
    digits.erase(0, digits.find_first_not_of('0'));
    const char* const prefix = base == radix::decimal ? "" : "0x";
    return lexed_number{digits.empty() ? integer(0) : integer(prefix + digits), scale, base};
}

std::optional<std::string_view> interval_sign_at(std::string_view rest) {
    for (const std::string_view sign : {"+-", "-+", "\u00b1", "\u2213"}) {
        if (rest.starts_with(sign)) {
            return sign;
        }
    }
    return std::nullopt;
}

}  // namespace libration
