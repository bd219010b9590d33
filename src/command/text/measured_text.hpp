// Numbers in prose that come from tables: what was measured is never typed into a sentence.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "text/table.hpp"

namespace libration {

/// The published table of a CSV by its stem (error_norm_double); std::nullopt if it was not made.
using table_source = std::function<std::optional<table>(const std::string& stem)>;

/// The text with every {{...}} replaced by a number from the tables:
///
///     {{max error of libration_series where order=2 to 2}}        the largest cell of a column, to 2 digits
///     {{the order of terms where gap=1e-12 digits=10 to 4}}       the only value that the rows have
///     {{max error of A where order=20 / max error of B to 2}}     a quotient of two
///
/// with max, min or the; conditions compare numbers by value and other cells as text. If a table or a row is
/// missing, the text contains "(not measured)". Throws std::runtime_error for a malformed placeholder, and for a column
/// that its table does not have.
std::string measured_text(const std::string& text, const table_source& tables);

/// The replacement for a number that was not measured.
inline constexpr const char* not_measured = "(not measured)";

}  // namespace libration
