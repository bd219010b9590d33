// The added unknowns of a polynomial form as Taylor models of the initial values.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "taylor_model.hpp"

namespace libration::ode {

/// Models of all unknowns at the initial point from models of the given ones, y(a). An added unknown is a function g of
/// them; with c the constant coefficients of y, w(s) = g(c + s (y - c)) satisfies w' = g_y(c + s (y - c)) (y - c), a
/// polynomial system for w and c + s (y - c), and g(y) = w(1): theorem T for all a at once. std::nullopt if that is not
/// reached, as where g is singular before.
std::optional<std::vector<taylor_model>> lifted_models(const polynomial_form& of,
                                                       const std::vector<taylor_model>& given);

}  // namespace libration::ode
