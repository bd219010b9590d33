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

/// f(x), of an order where f has one, where it is a number of a single unit again. Throws libration::error of kind
/// argument outside the domain.
std::optional<plain_number> folded_function(function_kind f, const rational& order, const plain_number& x);

}  // namespace libration
