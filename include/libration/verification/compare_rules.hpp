// How `verify` compares a value with the true one: how the value is parsed, and which tolerance applies.
#pragma once

#include <optional>
#include <string>

#include "libration/scalar/ball/comparison.hpp"

namespace libration {

/// A value as it was written, which may be "nan" or "inf", and the name of its column.
struct written_value {
    std::string text;
    std::string name;
    /// Whether it is the decimal of a double (double_decimals): then the value is that double, and the default tolerance
    /// half a unit in its last place.
    bool of_double = false;
};

/// Tolerances: absolute, relative to |true value| (a value passes if it satisfies one of the two), or in units in the
/// last place of a double of max(1, |true value|); by default one unit of the value's last digit as written, half of it
/// with `rounded`. If the true value is exactly 0, the scale of its function replaces |true value|: then a relative
/// tolerance is relative to the scale, and the last digit is that of a number of the scale with as many significant
/// digits.
struct compare_rules {
    std::optional<rational> tolerance = std::nullopt;
    std::optional<rational> relative = std::nullopt;
    std::optional<rational> ulps = std::nullopt;
    bool rounded = false;  ///< values are rounded to nearest, as in a printed table
    bool inputs_are_doubles = false;
    bool modulo_turn = false;  ///< theta is compared modulo 2 pi

    /// Whether the tolerance is that of the last digit as written.
    bool by_last_digit() const { return !tolerance && !relative && !ulps; }
};

/// Whether it is "nan" or "inf", in any case and with any sign.
bool is_not_finite(const std::string& value);

/// The decimal places to which the true value must be known to compare such a value; 17 at least.
/// Throws error if it is not a number.
long places_for(const std::string& value, const compare_rules& rules);

/// Compares a value as written with the true one at the working precision; std::nullopt if that is too low to decide.
/// "nan" has an infinite error, as "inf" unless the true value is infinite. Throws error if it is not a number.
std::optional<comparison> compare_value(const written_value& value, const true_value& truth, const compare_rules& rules,
                                        bool last_attempt);

}  // namespace libration
