// The value of a sign whose argument, an unknown that has become 0, remains 0: theorem H, "Emptying".
#pragma once

#include "libration/equation/hybrid_system.hpp"

namespace libration::ode {

/// 1/3, which is not a value of a step function. The right-hand side is the one as written where the argument is 0; that
/// on the other side is not defined about 0, as sqrt(h) is not about h = 0.
inline number emptied_value() { return number(rational(1, 3)); }
inline bool is_emptied(const number& value) { return denominator(value.fraction().value()) == 3; }

}  // namespace libration::ode
