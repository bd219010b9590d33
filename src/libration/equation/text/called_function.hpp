// Calls of functions in a formula.
#pragma once

#include <cstddef>
#include <optional>

#include "formula_cursor.hpp"
#include "libration/equation/equation_system.hpp"
#include "libration/function/function_kind.hpp"

namespace libration::ode {

/// The call of a function of function/list.hpp, the name at this index, which the cursor is behind.
expression read_function(const formula_cursor& at, std::size_t name, function_kind f);

/// The call of a function that is read as a formula (written_function.hpp), of `if` or `piecewise`, or of a synonym, the
/// name at this index, with a parenthesis at the cursor; std::nullopt for other names. Step functions are added to
/// `into`. Throws error for piecewise functions without it.
std::optional<expression> read_call(const formula_cursor& at, std::size_t name, equation_system* into);

}  // namespace libration::ode
