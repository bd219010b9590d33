// The numbers of a certificate as text.
#pragma once

#include <string>
#include <utility>

#include "certificate_step.hpp"
#include "libration/scalar/convert.hpp"

namespace libration::ode {

/// An exact number as integer times 2^-exponent.
std::pair<ball, long> mantissa_of(const ball& exact);
rational fraction_of(const ball& exact);

/// 27/20 as 135/100, over a power of ten if there is one.
std::string decimal_fraction(const rational& q);

/// The lines of a step.
std::string text_of(const certificate_step& step);

}  // namespace libration::ode
