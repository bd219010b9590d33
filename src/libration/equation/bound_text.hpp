// Times and bounds as they are written in messages.
#pragma once

#include <string>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

/// The time up to which a solution is proved to exist, rounded towards the initial point.
inline std::string proved_reach_text(const ball& reached, bool forward) {
    const precision_scope scope(20);
    const mpfr bound = midpoint_of(forward ? lower_bound(reached) : upper_bound(reached));
    return bound == 0 ? "0" : parts_of(bound, 12, forward ? MPFR_RNDD : MPFR_RNDU).text();
}

/// A time as a decimal of at most 12 digits, the exact one if it is that short.
inline std::string text_of_time(const number& time) {
    const auto fraction = time.fraction();
    const auto exact = fraction ? to_finite_decimal(*fraction, 12) : std::nullopt;
    if (exact) {
        return *exact;
    }
    const precision_scope scope(20);
    return to_decimal(constant_value<mpfr>::of(time), 12);
}

inline constexpr long digits_of_bounds = 12;

/// An exact number, rounded down or up.
inline std::string bound_text(const ball& exact, mpfr_rnd_t rounding) {
    const mpfr value = midpoint_of(exact);
    return value == 0 ? "0" : parts_of(value, digits_of_bounds, rounding).text();
}

/// The interval between two exact numbers, rounded outwards.
inline std::string interval_text(const ball& from, const ball& to) {
    return "[" + bound_text(from, MPFR_RNDD) + ", " + bound_text(to, MPFR_RNDU) + "]";
}

/// Decimals between which every number of the ball lies.
inline std::string bounds_text(const ball& x) { return interval_text(lower_bound(x), upper_bound(x)); }

}  // namespace libration::ode
