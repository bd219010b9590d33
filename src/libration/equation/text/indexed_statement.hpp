// Statements with indices, such as q[i]' = p[i] for i = 1..100, written out.
#pragma once

#include <cstddef>
#include <vector>

#include "statement.hpp"

namespace libration::ode {

/// The most symbols of the statements of one problem after indices are written out.
inline constexpr std::size_t most_written_symbols = 3'000'000;

/// Writes out statements that end in `for i = 1..100`, one for each value of the index, and indices in brackets directly
/// after a name: q[i+1] is the name q[3] where i is 2; u[i, j] and u[i][j] are the same. Several ranges, `for i = 1..9
/// for j = 1..i`, of which the first one changes slowest. Indices and ends of ranges are whole numbers: of the indices of
/// the statement, numbers, + - * /, parentheses and mod, for rings q[i mod 40 + 1], >= 0 as in Python. Elsewhere in the
/// statement i is that number, and (i mod 3) is computed too. Cost: linear in the length of what is written out. Throws
/// error for an index that is not a whole number, an empty range, and too many symbols.
void write_out_indices(std::vector<statement>& all);

}  // namespace libration::ode
