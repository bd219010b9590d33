// Powers and functions of exact numbers with exact results.
#pragma once

#include <optional>

#include "libration/number/exact_real.hpp"

namespace libration {

/// The fraction itself; throws libration::error of kind argument if its numerator or denominator has more than a
/// million bits.
rational within_limits(rational q);

/// base^exponent if it is a fraction. Throws libration::error of kind argument if the power has no real value or is
/// beyond the limits.
std::optional<rational> folded_power(const rational& base, const rational& exponent);

/// f(x), with an order if f has one, if it is a number of a single unit again. Throws libration::error of kind argument
/// outside the domain.
std::optional<plain_number> folded_function(function_kind f, const rational& order, const plain_number& x);

}  // namespace libration
