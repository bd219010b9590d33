// Whole numbers computed from indices, as in q[i mod 40 + 1].
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "statement.hpp"

namespace libration::ode {

/// The indices of a statement with their values.
using index_values = std::map<std::string, long, std::less<>>;

/// The largest absolute value of an index and of whatever an index is computed from.
inline constexpr long largest_index = 1'000'000;

/// How indices are written, for messages.
inline constexpr const char* form_of_range = "write `q[i]' = p[i] for i = 1..100`";

/// Whether the token is this name, without primes.
bool is_name_of(const token& word, std::string_view name);
/// Whether the token of this index exists and is `mod` between two numbers.
bool is_mod(const statement& words, std::size_t at);

/// The number in the tokens from one index up to, but not including, another: of whole numbers, indices, + - * /,
/// parentheses, and mod, which has the sign of the divisor as in Python, between two numbers or as mod(i, 3). Throws error
/// if it is not a whole number, or beyond largest_index.
long index_value(const statement& words, std::size_t first, std::size_t last, const index_values& values);

}  // namespace libration::ode
