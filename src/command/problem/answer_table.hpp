// An answer of a solution as a table.
#pragma once

#include <map>
#include <string>

#include "libration/problem/answer.hpp"
#include "text/table.hpp"

namespace libration {

/// The names and meanings of columns in the output, by the names in the answer.
using column_labels = std::map<std::string, column>;

/// The columns of an answer. If it is proved and has no column `uncertainty`, that of every number is a further column,
/// NAME_uncertainty, after the last of the numbers.
table table_of(const answer& found, const column_labels& labels = {});

/// Its notes, a line each: "radius        1.57 +- 1e-9".
std::string lines_of_notes(const answer& found);

}  // namespace libration
