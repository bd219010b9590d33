// The sign of a function of the solution just after the initial point, by exact arithmetic on the numbers as typed.
#pragma once

#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/ball_expansion.hpp"

namespace libration::ode {

/// gamma(t) = g(t, y(t)) about the initial point t0: its first derivative that is nonzero there determines its sign on
/// both sides.
struct start_sign {
    /// k: gamma(t0) = .. = gamma^(k-1)(t0) = 0 exactly, gamma^(k)(t0) is nonzero. For k = 0, gamma is nonzero at the
    /// initial point.
    int order = 0;
    /// The sign of gamma^(k)(t0): +1 or -1.
    int sign = 1;
    /// gamma^(k) in leaves and the variable, by applying Dg(y) f(y) k times.
    expression leading;

    /// The sign of gamma at small distances on one side: before the initial point for direction < 0, else after it.
    int beside(int direction) const { return direction < 0 && order % 2 != 0 ? -sign : sign; }
};

inline constexpr int most_orders_at_start = 6;

/// For g in leaves, with `slope` its derivative along the solution, at a nonsingular initial point. The sign is
/// determined by a ball that excludes 0, else by the value as an exact expression: a fraction that is 0, or an
/// expression whose sign is found with increasing precision (expression::sign). Throws error of the kind undecided if
/// that does not determine whether a value is 0, and if all derivatives up to most_orders_at_start are 0.
start_sign sign_at_start(const first_order_form& form, const expression& g, const expression& slope,
                         const number& point);

}  // namespace libration::ode
