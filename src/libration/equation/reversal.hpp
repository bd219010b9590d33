// Reversals of time that change signs of components, or reflect them at numbers.
#pragma once

#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// The signs of a reversal diag(+-1) under which the initial point is invariant: f(R y) = -R f(y) identically, and the
/// components with the sign -1 are exactly 0 there. Empty without one, and for more than 12 components that are 0.
std::vector<int> reversal_of(const first_order_form& form);

/// Whether f(S y) = -R f(y) identically for R = diag(signs) and S y = c + R (y - c), which exact arithmetic shows.
/// Without `centre` c is 0. The slopes must not contain the variable.
bool is_reversal(const first_order_form& form, const std::vector<int>& signs,
                 const std::vector<expression>& centre = {});

/// Whether an expression vanishes identically, as far as exact arithmetic shows.
bool is_zero_sum(const expression& e);

/// Whether e(R y) = -e(y) identically, by exact arithmetic.
bool is_odd_under(const first_order_form& form, const expression& e, const std::vector<int>& signs);

}  // namespace libration::ode
