// Unknowns that have the name of a column of tables.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace libration::ode {

/// The unknowns of a text (parse.hpp) with the name of another column of tables, n, time, digits, rigour, time_typed or
/// count, each with the name that the system and its column have instead: n_. Texts that refer to the system may use
/// both. Throws error for text that is not a statement.
std::map<std::string, std::string> renamed_unknowns(std::string_view text);

/// The name in the text of the unknown that is in this column: n of n_; that of the column itself, unless it is such a
/// name.
std::string_view name_before_renaming(std::string_view column);

}  // namespace libration::ode
