// The sign of a function of the solution directly behind the start, by exact arithmetic on what was typed.
#pragma once

#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/first_order_form.hpp"

namespace libration::ode {

/// gamma(t) = g(t, y(t)) about the start t0: the first of its derivatives that is not 0 there, which decides its sign
/// on both sides.
struct start_sign {
    /// k: gamma(t0) = .. = gamma^(k-1)(t0) = 0 exactly, gamma^(k)(t0) is not 0. gamma is not 0 at the start for k = 0.
    int order = 0;
    /// That of gamma^(k)(t0): +1 or -1.
    int sign = 1;
    /// gamma^(k) in leaves and the variable, by Dg(y) f(y) k times.
    expression leading;

    /// The sign of gamma at small distances on one side: for direction < 0 before the start, else behind it.
    int beside(int direction) const { return direction < 0 && order % 2 != 0 ? -sign : sign; }
};

inline constexpr int most_orders_at_start = 6;

/// Of g in leaves, `slope` its derivative along the solution, at a start that is not singular. A ball that excludes 0
/// decides, else the value as an exact expression: a fraction that is 0, or one of which more and more bits show the
/// sign (expression::sign). Throws error of the kind undecided where that does not show whether a value is 0, and where
/// all derivatives up to most_orders_at_start are 0.
start_sign sign_at_start(const first_order_form& form, const expression& g, const expression& slope,
                         const number& point);

}  // namespace libration::ode
