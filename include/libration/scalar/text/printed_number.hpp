// Numbers as they are printed: decimals with the digits that were asked for. No header of a scalar is needed to hold
// one.
#pragma once

#include <ostream>
#include <string>

namespace libration {

/// A decimal, each of its digits right to one unit in the last, by arithmetic that rounds.
struct rounded_decimal {
    std::string text;
};

/// A decimal and an upper bound of its distance to the exact number, below one unit of its last digit.
struct proved_decimal {
    std::string text;
    std::string uncertainty;  ///< three digits, rounded up; 0 where the decimal is exact
};

/// The decimals alone.
inline std::ostream& operator<<(std::ostream& out, const rounded_decimal& number) { return out << number.text; }
inline std::ostream& operator<<(std::ostream& out, const proved_decimal& number) { return out << number.text; }

}  // namespace libration
