// Comparison of a written number with a proved one.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "libration/scalar/ball/decimal.hpp"

namespace libration {

/// A number that values are compared with.
struct true_value {
    ball enclosure;
    /// The fraction, if the number is known to be one; then the enclosure is not used.
    std::optional<rational> exactly = std::nullopt;
    /// The scale of errors if the number is exactly 0, for example the largest value of its function.
    ball scale = ball(1);
    /// +1 or -1 if it is infinite.
    int infinite = 0;

    bool is_zero() const { return exactly ? *exactly == 0 : is_exact(enclosure) && contains_zero(enclosure); }
    /// As a ball, at the working precision.
    ball value() const { return exactly ? from_rational<ball>(*exactly) : enclosure; }
    /// The size that errors are relative to: |value|, or the scale if that is 0.
    ball size() const { return is_zero() ? scale : abs(value()); }
};

/// The largest admissible error and, if it is a fraction, that fraction.
struct error_bound {
    ball value;
    std::optional<rational> exactly = std::nullopt;

    explicit error_bound(ball of) : value(std::move(of)) {}
    explicit error_bound(const rational& of) : value(from_rational<ball>(of)), exactly(of) {}
};

/// What is proved about |value - truth|.
struct comparison {
    bool within;            ///< at most the tolerance
    std::string reference;  ///< the truth: each digit correct to one unit in the last; empty if none is proved
    std::string error;      ///< three digits; an upper bound if the value agrees with all computed digits
    /// -log10 |error/truth| rounded down to tenths, at least 0, in tenths, with the scale instead if the truth is 0;
    /// std::nullopt if the error is 0.
    std::optional<long> tenths_of_digits;
    mpfr of_tolerance;  ///< error/tolerance, roughly
};

/// A number below 2^-1000000 is printed as 0.
inline constexpr long smallest_exponent = -1'000'000;

/// The truth with its last digit at 10^-places or, close to 0, with three digits; std::nullopt if that is not proved.
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
inline std::optional<long> tenths_of_digits(const ball& error, const ball& size) {
    if (arb_is_zero(error.handle()) != 0) {
        return std::nullopt;
    }
    if (binary_exponent(size) < smallest_exponent) {
        return 0;
    }
    const precision_scope scope(20);
    const mpfr ratio = widen(midpoint_of(error)) / abs(widen(midpoint_of(size)));
    const mpfr digits = ratio == 0 ? mpfr(0) : mpfr(-log10(ratio) * 10);
    return digits > 0 ? static_cast<long>(mpfr_get_si(handle(digits), MPFR_RNDD)) : 0L;
}

/// The comparison for an infinite error: not a number, or a finite value if the truth is infinite.
inline comparison infinite_error(std::string reference) {
    comparison result{false, std::move(reference), "inf", 0, mpfr(0)};
    mpfr_set_inf(handle(result.of_tolerance), 1);
    return result;
}

/// Compares a value; returns std::nullopt if the working precision is not sufficient. In a last attempt an error that
/// may be 0 is given by its upper bound, and a truth that may be 0 is left out. The reference is printed down to
/// 10^-places.
inline std::optional<comparison> compare(const rational& value, const true_value& truth, const error_bound& tolerance,
                                         long places, bool last_attempt) {
    const ball here = truth.value();
    if (!is_finite(here)) {
        return std::nullopt;
    }
    const ball error = abs(truth.exactly ? from_rational<ball>(rational(value - *truth.exactly))
                                         : ball(from_rational<ball>(value) - here));
    const bool decided_exactly = truth.exactly && tolerance.exactly;
    const bool within = decided_exactly ? abs(rational(value - *truth.exactly)) <= *tolerance.exactly
                                        : arb_le(error.handle(), tolerance.value.handle()) != 0;
    const auto known = reference_text(here, places);
    if ((!known && !last_attempt) || (!within && !decided_exactly && !certainly_less(tolerance.value, error))) {
        return std::nullopt;
    }
    std::string reference = known.value_or("");
    if (binary_exponent(error) < smallest_exponent) {
        return comparison{within, std::move(reference), "0", std::nullopt, mpfr(0)};
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
    return comparison{within, std::move(reference), narrow_enough ? text->text : upper_bound_text(error),
                      tenths_of_digits(bound, truth.size()), midpoint_of(bound / tolerance.value)};
}

}  // namespace libration
