// Values that nothing changes between events.
#pragma once

#include <algorithm>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Whether the derivative of an unknown or of a lower derivative is 0 by an equation, as typed: n' = 0.
inline bool has_zero_slope(const equation_system& in, const expression& leaf) {
    return std::ranges::any_of(
        in.equations, [&](const equation& each) { return each.right.is(0) && same_form(each.left, derivative(leaf)); });
}

}  // namespace libration::ode
