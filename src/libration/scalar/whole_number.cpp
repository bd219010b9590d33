#include "libration/scalar/whole_number.hpp"

#include <charconv>
#include <limits>
#include <optional>
#include <system_error>

#include "libration/scalar/error.hpp"

namespace libration {

namespace {

// Out-of-range values become the largest or the smallest number; std::nullopt if the text is not a number.
std::optional<long> number_of(std::string_view digits) {
    long value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem == std::errc::invalid_argument || end != digits.data() + digits.size()) {
        return std::nullopt;
    }
    if (problem == std::errc()) {
        return value;
    }
    return digits.front() == '-' ? std::numeric_limits<long>::min() : std::numeric_limits<long>::max();
}

// Exact up to `largest`, otherwise something larger.
long times_power_of_ten(long value, long exponent, long largest) {
    for (; exponent > 0 && value > 0 && value <= largest; --exponent) {
        value = value > largest / 10 ? std::numeric_limits<long>::max() : value * 10;
    }
    return value;
}

}  // namespace

long read_whole_number(std::string_view text, long largest, const std::string& subject) {
    const std::size_t e = text.find_first_of("eE");
    const auto value = number_of(text.substr(0, e));
    const auto exponent = e == std::string_view::npos ? std::optional(0L) : number_of(text.substr(e + 1));
    if (!value || !exponent || *exponent < 0) {
        throw error(error_kind::argument, subject, "", "is not a whole number");
    }
    const long whole = times_power_of_ten(*value, *exponent, largest);
    if (whole < 0 || whole > largest) {
        throw error(error_kind::argument, subject, "", "is not between 0 and " + std::to_string(largest));
    }
    return whole;
}

}  // namespace libration
