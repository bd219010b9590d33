// How `verify` compares a value with the truth: what is read of it, and which tolerance it has.
#pragma once

#include <optional>
#include <string>

#include "libration/scalar/ball/comparison.hpp"

namespace libration {

/// Tolerances: absolute, relative to |truth| (a value passes that keeps one of the two), or in units in the last place
/// of a double of max(1, |truth|); with none of them one unit of the value's last digit as written. Where the truth is
/// exactly 0, the scale of its function takes the place of |truth|: then a relative tolerance is one of the scale, and
/// one unit of the last digit is that of a number of the scale with as many significant digits.
struct compare_rules {
    std::optional<rational> tolerance = std::nullopt;
    std::optional<rational> relative = std::nullopt;
    std::optional<rational> ulps = std::nullopt;
    bool inputs_are_doubles = false;
    bool modulo_turn = false;  ///< theta counts modulo 2 pi
};

/// The decimal places down to which the truth has to be known to compare such a value; 17 at least.
/// Throws error for what is no number.
long places_for(const std::string& value, const compare_rules& rules);

/// Compares what is written with the truth at the working precision; nothing where that decides too little. "nan" is
/// infinitely wrong, "inf" where the truth is not infinite. Throws error for what is no number.
std::optional<comparison> compare_value(const std::string& value, const true_value& truth, const compare_rules& rules,
                                        bool last_attempt);

}  // namespace libration
