// Whether a proved decimal has a proved digit.
#pragma once

#include "libration/scalar/text/printed_number.hpp"

namespace libration {

/// Whether the bound leaves the first digit of the decimal, that is, is at most one unit of it. So do 0, whose bound is
/// all that is known of it, inf, and what is exact. For decimals as they are printed; of other texts unspecified.
bool has_a_digit(const proved_decimal& number);

}  // namespace libration
