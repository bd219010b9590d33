// Shooting to a condition at infinity from two sides, each of which is proved by an integration.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

enum class side { above, below };
/// On which side the solution is, from its values at a time; std::nullopt if that is not decided there.
using state_test = std::function<std::optional<side>(const std::vector<ball>&)>;

/// Bits of an integration from one side in addition to those of the result.
inline constexpr long side_guard_bits = 80;

/// The system with another value of a parameter, exactly.
equation_system with_value(equation_system system, const std::string& name, const mpfr& value);

/// The ball between two values of a parameter about the middle, in the working precision, once they are proved to be on
/// different sides. The second unknown must remain above `least` until then. Throws precision_exhausted if a side is
/// not decided.
ball between(const equation_system& given, const std::string& name, const mpfr& middle, const state_test& decided,
             const ball& least);

/// The value of a parameter for which the first derivative of the first unknown tends to target: by the secant method
/// for f'(T) = target in floating-point arithmetic, T increasing to time(bits), then proved by between(). Throws
/// precision_exhausted if a side is not decided, error of the kind undecided if the first guess does not converge.
ball proved_shot(const equation_system& given, const std::string& name, int target, const state_test& decided,
                 const ball& least, const std::function<int(long)>& time);

}  // namespace libration::ode
