// Whole numbers in the notation of the command line.
#pragma once

#include <string>
#include <string_view>

namespace libration {

/// The whole number from 0 to `largest` that a text denotes: digits, also with an exponent (1e6).
/// Throws error of the kind argument about `subject`, "is not a whole number" or "is not between 0 and LARGEST".
long read_whole_number(std::string_view text, long largest, const std::string& subject);

}  // namespace libration
