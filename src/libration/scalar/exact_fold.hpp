// Powers and functions of exact numbers that are exact again.
#pragma once

#include <optional>

#include "libration/scalar/expression.hpp"

namespace libration {

/// The fraction itself; throws libration::error of kind argument where its numerator or denominator has more than a
/// million bits.
rational within_limits(rational q);

/// base^exponent where it is a fraction. Throws libration::error of kind argument where the power has no real value or
/// is beyond the limits.
std::optional<rational> folded_power(const rational& base, const rational& exponent);

/// f(x) where it is a fraction of 1 or of pi: at 0 and 1; roots of squares; sin, cos, tan of fractions of pi and their
/// inverses (by Niven's theorem no others of these are rational). Throws libration::error of kind argument outside the
/// domain.
std::optional<plain_number> folded_function(elementary f, const plain_number& x);

}  // namespace libration
