// The extended system of a turning point, as conditions on the solution and its variation.
#pragma once

#include <cstddef>
#include <vector>

#include "shooting.hpp"

namespace libration::ode {

/// F(x, lambda) = 0 and F_x v = 0 with v_pivot = 1, in the free numbers x, lambda (the last of those given) and the
/// other components of v. With the variation u of the solution, u' = f_y u, u(t_0) = (dy(t_0)/dx) v,
///     (F_x v)_i = sum_j dg_i/dx_j v_j + sum_k dg_i/dy_k (u(t_k) + y'(t_k) sum_j dt_k/dx_j v_j).
/// `values` are the first guesses of x and lambda, `direction` of v.
shooting turning_point_conditions(const shooting& conditions, const std::vector<number>& values,
                                  const std::vector<number>& direction, std::size_t pivot, const proof_route& route,
                                  const march_watch& watch);

}  // namespace libration::ode
