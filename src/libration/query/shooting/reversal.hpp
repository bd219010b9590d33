// Reversals of time that change signs of components.
#pragma once

#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// The signs of a reversal diag(+-1) under which the initial point is invariant: f(R y) = -R f(y) identically, and the
/// components with the sign -1 are exactly 0 there. Empty without one, and for more than 12 components that are 0.
std::vector<int> reversal_of(const first_order_form& form);

/// Whether e(R y) = -e(y) identically, by exact arithmetic.
bool is_odd_under(const first_order_form& form, const expression& e, const std::vector<int>& signs);

}  // namespace libration::ode
