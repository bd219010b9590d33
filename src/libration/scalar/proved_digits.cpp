#include "libration/scalar/proved_digits.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace libration {

namespace {

// The significant digits of a decimal, the first of them at 10^place.
struct significant_digits {
    std::string_view text;
    long place;

    bool is_power_of_ten() const {
        return text.front() == '1' &&
               std::all_of(text.begin() + 1, text.end(), [](char c) { return c == '0' || c == '.'; });
    }
};

// std::nullopt for 0 and for texts without digits.
std::optional<significant_digits> digits_of(std::string_view decimal) {
    const std::size_t e = std::min(decimal.find('e'), decimal.size());
    const std::string_view significand = decimal.substr(0, e);
    const std::size_t first = significand.find_first_of("123456789");
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    const std::size_t point = std::min(significand.find('.'), significand.size());
    const long exponent = e < decimal.size() ? std::strtol(std::string(decimal.substr(e + 1)).c_str(), nullptr, 10) : 0;
    const long before = static_cast<long>(point) - static_cast<long>(first);
    return significant_digits{significand.substr(first), exponent + (before > 0 ? before - 1 : before)};
}

}  // namespace

bool has_a_digit(const proved_decimal& number) {
    const auto bound = digits_of(number.uncertainty);
    const auto decimal = digits_of(number.text);
    if (!bound || !decimal) {
        return true;
    }
    return bound->place < decimal->place || (bound->place == decimal->place && bound->is_power_of_ten());
}

}  // namespace libration
