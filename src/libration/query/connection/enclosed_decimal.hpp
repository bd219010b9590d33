// Printed decimals as balls.
#pragma once

#include <string>

#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// The decimal that a text is, in the working precision.
inline ball ball_of_text(const std::string& text) {
    ball value;
    arb_set_str(value.handle(), text.c_str(), ball::working_bits());
    return value;
}

/// All numbers within the uncertainty of a decimal.
inline ball enclosed(const proved_decimal& of) {
    return widened(ball_of_text(of.text), magnitude(ball_of_text(of.uncertainty)));
}

}  // namespace libration::ode
