// Whether a proved decimal has a proved digit.
#pragma once

#include "libration/scalar/printed_number.hpp"

namespace libration {

/// Whether the bound confirms the first digit of the decimal, that is, is at most one unit of it. Also true for 0,
/// about which nothing but the bound is known, for inf, and for exact numbers. For decimals as they are printed; for
/// other texts unspecified.
bool has_a_digit(const proved_decimal& number);

}  // namespace libration
