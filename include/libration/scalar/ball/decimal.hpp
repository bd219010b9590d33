// Decimal output of balls: only proved digits are printed.
#pragma once

#include <optional>
#include <string>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration {

/// +-0.d1d2d3... 10^exponent.
struct decimal_parts {
    bool negative;
    std::string digits;
    long exponent;

    std::string text() const { return place_point(negative, digits, exponent); }
    /// 10^exponent in units of the last digit.
    long last_place() const { return exponent - static_cast<long>(digits.size()); }
    /// The number, exact if the working precision suffices.
    ball value() const {
        const ball significand = from_rational<ball>(rational(integer(digits))) * (negative ? -1 : 1);
        return last_place() < 0 ? significand / pow(ball(10), -last_place())
                                : significand * pow(ball(10), last_place());
    }
    /// One unit of the last digit.
    ball unit() const { return pow(ball(10), last_place()); }
};

/// x, which is nonzero, rounded to `count` digits.
inline decimal_parts parts_of(const mpfr& x, long count, mpfr_rnd_t rounding) {
    mpfr_exp_t exponent = 0;
    char* raw = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(count), handle(x), rounding);
    std::string digits = raw;
    mpfr_free_str(raw);
    const bool negative = digits.front() == '-';
    return {negative, digits.substr(negative ? 1 : 0), static_cast<long>(exponent)};
}

/// The largest |number| of a ball, rounded up to three significant digits.
inline std::string upper_bound_text(const ball& x) {
    ball largest;
    arb_get_abs_ubound_arf(arb_midref(largest.handle()), x.handle(), 60);
    const mpfr bound = midpoint_of(largest);
    return bound == 0 ? "0" : is_finite(x) ? parts_of(bound, 3, MPFR_RNDU).text() : "inf";
}

/// An upper bound with three significant digits on every |number| of a ball that is not the exact 0.
inline std::string bound_text(const ball& x) {
    ball largest;
    arb_get_abs_ubound_arf(arb_midref(largest.handle()), x.handle(), 60);
    const precision_scope scope(20);
    return !is_finite(x) ? "inf" : parts_of(midpoint_of(largest * (ball(1) + pow(ball(2), -40L))), 3, MPFR_RNDU).text();
}

/// The midpoint with `count` significant digits, if every number of the ball is less than one unit of the last of them
/// away from the printed value; otherwise std::nullopt. Only the ball 0 is printed as 0.
/// Throws error if count < 1.
inline std::optional<proved_decimal> to_proved_decimal(const ball& x, long count) {
    if (count < 1) {
        throw error(error_kind::argument, "number of digits", std::to_string(count), "is less than one");
    }
    if (!is_finite(x)) {
        return std::nullopt;
    }
    const mpfr centre = midpoint_of(x);
    if (centre == 0) {
        return is_exact(x) ? std::optional<proved_decimal>({"0", "0"}) : std::nullopt;
    }
    // The decimal as a number compared with the ball; the 20 additional digits are for its power of 10.
    const decimal_parts printed = parts_of(centre, count, MPFR_RNDN);
    const precision_scope scope(count + 20);
    const ball error = x - printed.value();
    if (!certainly_less(abs(error), printed.unit())) {
        return std::nullopt;
    }
    return proved_decimal{printed.text(), upper_bound_text(error)};
}

/// The number of significant digits of the midpoint proved in this sense, up to `most`; 0 if there are none. O(log
/// most) conversions.
inline long proved_digits(const ball& x, long most) {
    if (to_proved_decimal(x, most)) {
        return most;
    }
    long proved = 0;
    for (long unproved = most; unproved - proved > 1;) {
        const long middle = proved + (unproved - proved) / 2;
        (to_proved_decimal(x, middle) ? proved : unproved) = middle;
    }
    return proved;
}

}  // namespace libration
