// Proved digits: a list of balls is computed again with more guard digits until every digit that is printed is proved.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "libration/scalar/ball/decimal.hpp"

namespace libration {

/// The most guard digits before a proof is given up: 20, doubled nine times.
inline constexpr long most_guard_digits = 10'240;

/// compute() returns balls in the working precision; they are printed with `digits` digits, each proved. vanishing() is
/// asked, once, which of them are exactly 0, when a ball keeps containing 0: no precision would decide that.
/// Throws std::runtime_error where a proof is impossible: a digit is not decided by most_guard_digits more.
template <class Compute, class Vanishing>
std::vector<proved_decimal> proved_decimals(long digits, const Compute& compute, const Vanishing& vanishing) {
    std::optional<std::vector<bool>> zero;
    for (long guard = 20; guard <= most_guard_digits; guard *= 2) {
        const precision_scope scope(digits + guard);
        try {
            const std::vector<ball> values = compute();
            std::vector<proved_decimal> printed;
            printed.reserve(values.size());
            for (const ball& value : values) {
                const std::size_t at = printed.size();
                if (!zero && guard > 20 && contains_zero(value)) {
                    zero = vanishing();
                }
                const bool vanishes = zero && at < zero->size() && (*zero)[at];
                const auto decimal = vanishes ? proved_decimal{"0", "0"} : to_proved_decimal(value, digits);
                if (!decimal) {
                    break;
                }
                printed.push_back(*decimal);
            }
            if (printed.size() == values.size()) {
                return printed;
            }
        } catch (const precision_exhausted&) {
            continue;
        }
    }
    throw std::runtime_error(
        fmt::format("a proof is impossible: {} digits are not decided with {} more", digits, most_guard_digits));
}

/// The same for numbers that are known not to be 0.
template <class Compute>
std::vector<proved_decimal> proved_decimals(long digits, const Compute& compute) {
    return proved_decimals(digits, compute, [] { return std::vector<bool>(); });
}

}  // namespace libration
