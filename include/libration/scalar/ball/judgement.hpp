// A written number against a proved one.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "libration/scalar/ball/decimal.hpp"

namespace libration {

/// What is proved of |value - truth|.
struct judgement {
    bool within;            ///< at most the tolerance
    std::string reference;  ///< the truth: each digit right to one unit in the last
    std::string error;      ///< three digits; an upper bound where the value agrees with all that was computed
    /// -log10 |error/truth| rounded down to tenths, at least 0, in tenths; nothing where the error is 0.
    std::optional<long> tenths_of_digits;
    mpfr of_tolerance;  ///< error/tolerance, roughly
};

/// Below 2^-1000000 a number is printed as 0.
inline constexpr long smallest_exponent = -1'000'000;

/// The truth with its last digit at 10^-places or, next to 0, with three digits; nothing where that is not proved.
inline std::optional<std::string> reference_text(const ball& truth, long places) {
    const long exponent = binary_exponent(truth);
    if (exponent < smallest_exponent) {
        return "0";
    }
    const long before_point = exponent > 0 ? decimal_digits(exponent) : -(decimal_digits(-exponent) - 1);
    const auto printed = to_proved_decimal(truth, std::max(3L, places + before_point));
    return printed ? std::optional<std::string>(printed->text) : std::nullopt;
}

/// Correct digits in tenths, from the midpoints.
inline std::optional<long> tenths_of_digits(const ball& error, const ball& truth) {
    if (arb_is_zero(error.handle()) != 0) {
        return std::nullopt;
    }
    if (binary_exponent(truth) < smallest_exponent) {
        return 0;
    }
    const precision_scope scope(20);
    const mpfr ratio = widen(midpoint_of(error)) / abs(widen(midpoint_of(truth)));
    const mpfr digits = ratio == 0 ? mpfr(0) : mpfr(-log10(ratio) * 10);
    return digits > 0 ? static_cast<long>(mpfr_get_si(handle(digits), MPFR_RNDD)) : 0L;
}

/// Judges a value; nothing where the working precision decides too little. In a last attempt an error that may be 0 is
/// given by its upper bound. The reference is printed down to 10^-places.
inline std::optional<judgement> judge(const rational& value, const ball& truth, const ball& tolerance, long places,
                                      bool last_attempt) {
    if (!is_finite(truth)) {
        return std::nullopt;
    }
    const ball error = abs(ball(from_rational<ball>(value) - truth));
    const bool within = arb_le(error.handle(), tolerance.handle()) != 0;
    const auto reference = reference_text(truth, places);
    if (!reference || (!within && !certainly_less(tolerance, error))) {
        return std::nullopt;
    }
    if (binary_exponent(error) < smallest_exponent) {
        return judgement{within, *reference, "0", std::nullopt, mpfr(0)};
    }
    auto text = to_proved_decimal(error, 3);
    const bool narrow_enough = text && (is_exact(error) || certainly_less(ldexp(radius_of(error), 10), error));
    if (!narrow_enough && !last_attempt) {
        return std::nullopt;
    }
    ball bound = error;
    if (!narrow_enough) {
        arb_get_abs_ubound_arf(arb_midref(bound.handle()), error.handle(), 60);
        mag_zero(arb_radref(bound.handle()));
    }
    return judgement{within, *reference, narrow_enough ? text->text : upper_bound_text(error),
                     tenths_of_digits(bound, truth), midpoint_of(bound / tolerance)};
}

}  // namespace libration
