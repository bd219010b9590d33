// Numbers as they are printed: decimals with the requested digits. Independent of the scalar headers.
#pragma once

#include <ostream>
#include <string>

namespace libration {

/// A decimal, each of its digits correct to one unit in the last, by rounding arithmetic.
struct rounded_decimal {
    std::string text;
};

/// A decimal and an upper bound on its distance from the exact number, below one unit of its last digit.
struct proved_decimal {
    std::string text;
    std::string uncertainty;  ///< three digits, rounded up; 0 if the decimal is exact
};

/// Only the decimals.
inline std::ostream& operator<<(std::ostream& out, const rounded_decimal& number) { return out << number.text; }
inline std::ostream& operator<<(std::ostream& out, const proved_decimal& number) { return out << number.text; }

}  // namespace libration
