// Fractions near balls, with few digits.
#pragma once

#include "../query/certificate/certificate.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// The midpoint.
rational fraction_near(const ball& x);

/// The multiple of the unit that is nearest to x.
rational rounded_to(const rational& x, const rational& unit);

/// The largest power of ten that is not above x > 0.
rational power_of_ten_below(const rational& x);

/// An interval about the midpoint, at most `reach` to each side.
ode::decimal_interval interval_about(const ball& value, const rational& reach);

}  // namespace libration
