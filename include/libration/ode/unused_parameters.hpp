// What the text of a problem defines and does not use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace libration::ode {

/// The parameters of a text (parse.hpp) that stand in their definition alone, in alphabetical order. Throws error for
/// what is not a statement.
std::vector<std::string> unused_parameters(std::string_view text);

}  // namespace libration::ode
