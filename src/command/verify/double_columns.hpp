// Which columns of a file given to `verify` hold doubles, printed with more digits than these have.
#pragma once

#include <vector>

#include "text/csv_records.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// For each compared column, whether its cells in these records, without those that are not numbers, are the decimals
/// of doubles (double_decimals).
std::vector<bool> double_columns(const std::vector<csv_record>& records, separator between,
                                 const std::vector<compared_column>& compared);

/// Whether the columns at these places, of times and arguments, hold doubles: one of them decimals of doubles, and each
/// of the others these or numbers that are doubles, such as 2.5. Not if a cell is not a number.
bool are_double_columns(const std::vector<csv_record>& records, separator between,
                        const std::vector<std::size_t>& places);

}  // namespace libration
