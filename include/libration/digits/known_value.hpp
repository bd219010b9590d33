// A value as far as it is proved: with its digits or with a bound.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/printed_number.hpp"

namespace libration {

/// A value: its digits or, if no run within the limits proved them, only a bound; neither if the solution that it
/// depends on is not proved to reach the time.
struct known_value {
    std::optional<proved_decimal> decimal;  ///< every digit proved
    std::string bound;                      ///< without a decimal: proved |value| < bound, three digits, or empty
};

inline bool all_have_digits(const std::vector<known_value>& values) {
    return std::ranges::all_of(values, [](const known_value& each) { return each.decimal.has_value(); });
}

}  // namespace libration
