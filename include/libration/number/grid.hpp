// Lists and ranges of exact numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

/// The most values that one list or range may have.
inline constexpr long most_grid_values = 10'000'000;

/// Reads LIST, that is items with commas between them, each an exact number or a range:
///   a:b:count      count values from a to b, both included, evenly spaced and exact
///   a:b:COUNTlog   evenly spaced in the logarithm: a and b exact, those between rounded (to 6 digits or to
///                  a thousandth of a step, whichever is finer) and exact from then on
/// Throws error of the kind argument saying which item is wrong and why.
std::vector<exact> read_grid(std::string_view text);

/// An integer >= 0, at most `largest`. Throws error of the kind argument with the reason.
int read_count(std::string_view text, int largest);

}  // namespace libration
