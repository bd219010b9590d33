// Parameters that the text of a problem defines but does not use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace libration::ode {

/// The parameters of a text (parse.hpp) that occur only in their definition, in alphabetical order. Throws error for
/// text that is not a statement.
std::vector<std::string> unused_parameters(std::string_view text);

}  // namespace libration::ode
