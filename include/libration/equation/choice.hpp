// Which parts of an expression with step functions have to be defined.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// a where the indicator [u > 0] or [u >= 0], or 1 minus one, is 1, and b where it is 0: holds*a + (1 - holds)*b, with a
/// mark that distinguishes the products from those that are typed. The part that is not chosen need not be defined,
/// while a factor of a product has to be, whatever the others are: if(t > 3, log(1 - t), 0) is 0 at t = 2, and
/// if(t > 3, 1, 0)*log(1 - t) has no value there.
expression choice_between(const expression& holds, const expression& a, const expression& b);

/// The value of the parameter of this name; std::nullopt leaves it as it is.
using parameter_value = std::function<std::optional<expression>(const std::string& name)>;

/// The expression with parameters replaced, defined where it is as written. With `all_defined` what is not chosen has to
/// be defined, too: on a surface between both.
expression with_parameters(const expression& e, const parameter_value& value, bool all_defined = false);

}  // namespace libration::ode
