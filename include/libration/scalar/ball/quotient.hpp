// Quotients of whole sequences of mpfr numbers as the midpoints of quotients of balls, using FLINT. The radii determine
// whether they are accurate enough. A program selects it with whole_quotient_scope(quotient_by_flint).
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "libration/scalar/ball/polynomial.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/supplied_quotient.hpp"

namespace libration {

/// As specified for mpfr_quotient, in the working precision.
inline std::optional<std::vector<mpfr>> quotient_by_flint(const std::vector<mpfr>& a, const std::vector<mpfr>& b) {
    const auto exactly = [](const std::vector<mpfr>& numbers) {
        return std::vector<ball>(numbers.begin(), numbers.end());
    };
    const std::vector<ball> quotient = whole_quotient(exactly(a), exactly(b));
    // All |midpoints| are below 2^size, one is not below 2^(size-1); all radii are below 2^error.
    long size = std::numeric_limits<long>::min();
    long error = size;
    for (const ball& each : quotient) {
        if (!is_finite(each)) {
            return std::nullopt;
        }
        const ball radius = radius_of(each);
        size = std::max<long>(size, arf_abs_bound_lt_2exp_si(arb_midref(each.handle())));
        error = std::max<long>(error, arf_abs_bound_lt_2exp_si(arb_midref(radius.handle())));
    }
    constexpr long lost = 48;
    constexpr long far = 1L << 40;  // the exponents of 0 and of numbers that mpfr cannot represent are beyond
    if (std::clamp(error, -far, far) > std::clamp(size, -far, far) - 1 + lost - ball::working_bits()) {
        return std::nullopt;
    }
    std::vector<mpfr> midpoints;
    midpoints.reserve(quotient.size());
    for (const ball& each : quotient) {
        midpoints.push_back(midpoint_of(each));
    }
    return midpoints;
}

}  // namespace libration
