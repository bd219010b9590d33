// An interval as decimals, rounded outwards.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

/// Decimals between which all numbers from `lower` to `upper` lie, both exact: with the digits that resolve a thousandth
/// of the difference, at most so many, rounded down and up. Of a single number that is such a decimal without the zeros
/// at its end.
inline std::pair<std::string, std::string> outward_decimals(const ball& lower, const ball& upper, long most) {
    constexpr long least = 6;
    constexpr double digits_of_width = 4;
    const ball width = upper - lower;
    const auto rounded = [&](const ball& end, mpfr_rnd_t rounding) -> std::string {
        const mpfr exactly = midpoint_of(end);
        if (exactly == 0) {
            return "0";
        }
        long digits = most;
        if (!contains_zero(width)) {
            const double scale = (log_of(magnitude(end)) - log_of(magnitude(width))) / std::log2(10);
            digits = std::max(least, static_cast<long>(std::ceil((scale > 0 ? scale : 0) + digits_of_width)));
        }
        return parts_of(exactly, std::min(most, digits), rounding).text();
    };
    std::pair ends{rounded(lower, MPFR_RNDD), rounded(upper, MPFR_RNDU)};
    if (ends.first == ends.second && ends.first.find('.') != std::string::npos &&
        ends.first.find('e') == std::string::npos) {
        const auto last = ends.first.find_last_not_of('0');
        ends.first.resize(ends.first[last] == '.' ? last : last + 1);
        ends.second = ends.first;
    }
    return ends;
}

}  // namespace libration
