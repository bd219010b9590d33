// Numbers as other programs write them: decimals and hexadecimal floats, what their last digit is worth, and the double
// that a program makes of what was typed.
#pragma once

#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

/// Whether the text is [sign]0x..., as printf("%a") and float.hex() write.
inline bool is_hexadecimal(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    return text.starts_with("0x") || text.starts_with("0X");
}

/// digits * base^exponent, and what one unit of the last digit is worth.
struct written_number {
    rational value;
    rational last_place;
};

/// base^exponent.
inline rational power_of(int base, long exponent) {
    const integer power = boost::multiprecision::pow(integer(base), static_cast<unsigned>(std::labs(exponent)));
    return exponent < 0 ? rational(integer(1), power) : rational(power);
}

/// Reads [sign]digits[.digits][e[sign]digits] or [sign]0xhex[.hex][p[sign]digits], exactly: nothing is rounded. Throws
/// error saying what is wrong with the text; fractions and units have no last digit and are refused.
class written_number_reader {
public:
    explicit written_number_reader(std::string_view text) : rest_(text) {}

    written_number read() {
        const bool hexadecimal = is_hexadecimal(rest_);
        const bool negative = rest_.starts_with('-');
        if (negative || rest_.starts_with('+')) {
            rest_.remove_prefix(1);
        }
        rest_.remove_prefix(hexadecimal ? 2 : 0);
        const rational significand = digits_and_point(hexadecimal);
        const long exponent = written_exponent(hexadecimal ? 'p' : 'e');
        if (!rest_.empty()) {
            throw error(error_kind::argument, "number", "", "is not a number");
        }
        const rational unit =
            hexadecimal ? rational(power_of(2, exponent - 4 * places_)) : rational(power_of(10, exponent - places_));
        return {negative ? rational(-significand * unit) : rational(significand * unit), unit};
    }

private:
    static constexpr long largest_exponent = 100'000;

    rational digits_and_point(bool hexadecimal) {
        std::string digits;
        bool point = false;
        for (; !rest_.empty(); rest_.remove_prefix(1)) {
            const auto c = static_cast<unsigned char>(rest_.front());
            if (c == '.' && !point) {
                point = true;
            } else if (hexadecimal ? std::isxdigit(c) != 0 : std::isdigit(c) != 0) {
                digits += rest_.front();
                places_ += point ? 1 : 0;
            } else {
                break;
            }
        }
        if (digits.empty() || digits.size() > static_cast<std::size_t>(largest_exponent)) {
            throw error(error_kind::argument, "number", "", "is not a number");
        }
        // A leading 0 would mean octal.
        digits.erase(0, digits.find_first_not_of('0'));
        return digits.empty() ? rational(0) : rational(integer((hexadecimal ? "0x" : "") + digits));
    }

    long written_exponent(char letter) {
        if (rest_.empty() || std::tolower(static_cast<unsigned char>(rest_.front())) != letter) {
            return 0;
        }
        rest_.remove_prefix(1);
        const bool negative = rest_.starts_with('-');
        if (negative || rest_.starts_with('+')) {
            rest_.remove_prefix(1);
        }
        long value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (end == rest_.data() || error != std::errc() || value < 0 || value > largest_exponent) {
            throw error(error_kind::argument, "number", "",
                        end == rest_.data() ? "is not a number" : "is beyond the range 1e-100000 .. 1e100000");
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return negative ? -value : value;
    }

    std::string_view rest_;
    long places_ = 0;
};

inline written_number read_written(std::string_view text) { return written_number_reader(text).read(); }

/// What read_exact() reads, and hexadecimal floats. Throws error.
inline exact read_typed(std::string_view text) {
    return is_hexadecimal(text) ? exact{read_written(text).value, unit::one, std::string(text)} : read_exact(text);
}

/// The double nearest to a fraction, ties to even, as an exact number: what a program in double receives.
/// Throws error beyond the largest double.
inline rational nearest_double(const rational& q) {
    const double below = mpq_get_d(q.backend().data());  // towards 0
    const double above = std::nextafter(below, q.sign() * std::numeric_limits<double>::infinity());
    if (!std::isfinite(above)) {
        throw error(error_kind::argument, "number", "", "is beyond the largest double");
    }
    const rational lower(below);
    const rational upper(above);
    const rational from_lower = abs(rational(q - lower));
    const rational from_upper = abs(rational(upper - q));
    const bool even = std::bit_cast<std::uint64_t>(below) % 2 == 0;
    return from_lower < from_upper || (from_lower == from_upper && even) ? lower : upper;
}

/// The same of a typed number; an angle in degrees or multiples of pi becomes the double nearest to its radians. Throws
/// error for a multiple of the period, too.
inline exact nearest_double(const exact& number) {
    if (number.measure == unit::one) {
        return {nearest_double(number.coefficient), unit::one, number.text};
    }
    const auto radians = from_exact<double>(number);
    if (!std::isfinite(radians)) {
        throw error(error_kind::argument, "number", "", "is beyond the largest double");
    }
    return {rational(radians), unit::one, number.text};
}

}  // namespace libration
