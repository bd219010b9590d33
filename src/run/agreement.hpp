// Correct digits by two precisions: a list of numbers is computed again with more guard digits until nothing printed
// changes. It catches every loss that rounding causes (cancellation, a value next to 0); it does not judge the formula.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// Whether a and b are the same number to `digits` significant digits and two more.
inline bool agree(const mpfr& a, const mpfr& b, long digits) {
    const precision_scope scope(20);
    return abs(a - b) <= abs(b) * pow(mpfr(10), static_cast<int>(-digits - 2));
}

/// compute(guard) returns numbers meant to have the wanted digits when its arithmetic has `guard` digits more.
/// Throws std::runtime_error when 100000 guard digits are not enough.
template <class Compute>
std::vector<mpfr> agreed_values(long digits, const Compute& compute) {
    std::vector<mpfr> before = compute(20L);
    for (long guard = 45; guard <= 100'000; guard *= 2) {
        std::vector<mpfr> now = compute(guard);
        bool same = true;
        for (std::size_t i = 0; i < now.size() && same; ++i) {
            same = agree(before[i], now[i], digits);
        }
        if (same) {
            return now;
        }
        before = std::move(now);
    }
    throw std::runtime_error(fmt::format("{} digits are not reached with 100000 guard digits", digits));
}

}  // namespace libration
