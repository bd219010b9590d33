// The accuracy of the numbers of a list, estimated from their notation.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration::convergence {

/// Significant digits of a number written with a point or an exponent; 0 for whole numbers and fractions, which are
/// exact.
inline long written_digits(const exact& number) {
    const std::string& text = number.text;
    if (text.find('/') != std::string::npos || text.find_first_of(".eE") == std::string::npos) {
        return 0;
    }
    const std::string significand = text.substr(0, text.find_first_of("eE"));
    const std::size_t first = std::min(significand.find_first_of("123456789"), significand.size());
    return static_cast<long>(std::count_if(significand.begin() + static_cast<std::ptrdiff_t>(first), significand.end(),
                                           [](unsigned char c) { return std::isdigit(c) != 0; }));
}

/// The number of digits to which the decimals of a list are rounded: their common number of significant digits if that is
/// at least 17; 0, exact, otherwise.
inline long rounding_of(const std::vector<exact>& list) {
    constexpr long fewest = 17;
    std::optional<long> common;
    for (const exact& number : list) {
        const long digits = written_digits(number);
        if (digits > 0) {
            if (common && digits != *common) {
                return 0;
            }
            common = digits;
        }
    }
    return common.value_or(0) >= fewest ? *common : 0;
}

/// The relative accuracy of the numbers of a list: epsilon, or 10^(1-d) if that is larger, d the largest number of
/// digits among the decimals of the second half; never more than 2^-12, since a short decimal is as often exact (1e-7)
/// as rounded. Wrong if decimals were printed with more digits than are correct.
template <rounding_scalar T>
T noise_of(const std::vector<exact>& list) {
    using std::ldexp;
    constexpr int coarsest = -12;
    long written = 0;
    for (std::size_t n = list.size() / 2; n < list.size(); ++n) {
        written = std::max(written, written_digits(list[n]));
    }
    if (written == 0 || written > decimal_digits(digits<T>())) {
        return epsilon<T>();
    }
    const T last_place = from_rational<T>(
        rational(integer(1), boost::multiprecision::pow(integer(10), static_cast<unsigned>(written - 1))));
    return std::min(std::max(last_place, epsilon<T>()), T(ldexp(T(1), coarsest)));
}

}  // namespace libration::convergence
