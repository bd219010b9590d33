// Functions of other programs, as formulas of the functions of equations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libration/equation/expression.hpp"
#include "piecewise.hpp"

namespace libration::ode {

/// A function that is read as a formula in its arguments. Each has one entry in the table of written_function.cpp, with
/// its formula; docs/equations.md lists them with their domains.
struct written_function {
    std::string_view name;
    std::size_t fewest = 1;  ///< arguments
    std::size_t most = 1;
    std::string_view form;   ///< of a call, for messages: mod(x, y)
    bool piecewise = false;  ///< whether it contains step functions
    /// The formula. Without `steps` only smooth functions, and hypot without its absolute value. Throws error for
    /// constants outside the domain.
    expression (*value)(const std::vector<expression>& x, step_collector* steps) = nullptr;
};

/// The function of this name or of a synonym of it; null for other names, also `if` and `piecewise`, which have
/// conditions as arguments, and those of function/list.hpp.
const written_function* written_function_named(std::string_view name);

/// Their names, separated by spaces.
std::string written_function_names();

/// The name by which equations know a function: log for ln, atan for arctan, if for ifelse and where. The name itself if
/// it is not a synonym.
std::string_view name_without_synonym(std::string_view name);

/// Whether a name before a parenthesis is that of a function of equations or a synonym of one.
bool is_called_function(std::string_view name);

}  // namespace libration::ode
