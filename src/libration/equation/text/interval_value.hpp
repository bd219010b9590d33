// Intervals as the values of parameters and initial values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "libration/equation/equation_system.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

/// The interval [a, b] or a +- b in the tokens from this index to the end of the statement, as a set of this name;
/// std::nullopt if they are another value. Throws error for brackets that do not contain two ends, and for ends that are
/// not constant.
std::optional<number_set> set_in(const statement& words, std::size_t begin, const std::string& name,
                                 const known_names& names);

}  // namespace libration::ode
