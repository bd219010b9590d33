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

/// The lines of a step.
std::string text_of(const certificate_step& step);

}  // namespace libration::ode
