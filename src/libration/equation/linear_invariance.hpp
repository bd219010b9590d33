// Affine symmetries of an autonomous system, and constant skew forms that its flow conserves.
#pragma once

#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// Fields A y + b, A and b constant, whose flow maps solutions to solutions: f'(y)(A y + b) = A f(y) identically.
/// Each as its n components in leaves. The same limits.
std::vector<std::vector<expression>> affine_symmetries_of(const first_order_form& of);

/// Whether a constant regular skew matrix W satisfies W f'(y) + f'(y)^T W = 0 identically: the derivative M of the flow
/// then satisfies M^T W M = W. The same limits.
bool is_symplectic(const first_order_form& of);

}  // namespace libration::ode
