// Enclosures of all solutions of a set, compared with closed forms of their ranges.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace libration::tests {

/// Of the closed forms and comparisons.
inline constexpr long digits_of_ranges = 400;

inline ball value_of(const std::string& text) {
    return ode::constant_value<ball>::of(ode::parse_constant(text).constant());
}

/// Bounds of monotone values are taken at the ends: 1/1024 is far above the precision of 2^-64 of the width.
inline constexpr double sharp = 1 + 1.0 / 1024;

/// The interval contains the range from lower to upper, and is at most `times` as wide.
inline void check_range(const ode::closed_interval& found, const ball& lower, const ball& upper, double times) {
    const precision_scope scope(digits_of_ranges);
    INFO(text_of(found.lower) << " .. " << text_of(found.upper) << " should be " << text_of(lower) << " .. "
                              << text_of(upper));
    CHECK_FALSE(certainly_less(lower, found.lower));
    CHECK_FALSE(certainly_less(found.upper, upper));
    const ball allowed = (upper - lower) * from_rational<ball>(rational(static_cast<long>(times * 1024), 1024));
    CHECK_FALSE(certainly_less(allowed, found.upper - found.lower));
}

}  // namespace libration::tests
