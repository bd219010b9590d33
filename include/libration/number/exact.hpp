// Exact numbers: input as typed, stored exactly until a precision is chosen.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "libration/number/exact_real.hpp"
#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// coefficient * unit, exactly: 1.71, 171/100, 1e-30, 3pi/4, 150deg, -3T/4, and formulas that fold to this form
/// (2-1e-10, 3/4*pi); or the value of a formula: pi-1e-10, sqrt(2), T/4+1e-3.
struct exact {
    rational coefficient = 0;  ///< of an expression, 0
    unit measure = unit::one;
    std::string text = "0";  ///< as typed
    /// If measure is unit::expression.
    std::shared_ptr<const exact_real> formula = nullptr;
    /// Whether it was typed as a formula, even if it is a plain number.
    bool composed = false;

    /// The coefficient of pi of an angle; pi = 180 degrees. Only for pi and degree: throws std::logic_error otherwise.
    rational in_pi() const;
    /// Whether it is a fraction of pi.
    bool is_angle() const { return measure == unit::pi || measure == unit::degree; }
    /// Whether it is 0 by its form. An expression is not, even if it cannot be distinguished from 0.
    bool is_zero() const { return measure != unit::expression && coefficient == 0; }
    /// Whether it is a fraction without a unit.
    bool is_fraction() const { return measure == unit::one; }
    /// Whether it is a fraction or a formula without T, as opposed to a bare multiple of pi.
    bool is_number() const;
    /// The multiple of T contained in it.
    rational periods() const;
    /// Whether it contains one.
    bool has_periods() const { return measure == unit::period || periods() != 0; }
    /// Whether it is only a multiple of T (including 0).
    bool only_periods() const { return measure == unit::period || is_zero(); }
    /// Without the multiple of T.
    exact without_periods() const;
};

/// The number as a formula.
exact_real as_exact_real(const exact& number);
/// A formula as an exact number, plain if possible.
exact exactly(const exact_real& value, std::string text);

/// The exact number represented by a text: [sign] digits[.digits][e[sign]digits] [pi|deg|T] [/ digits...], the digits
/// optional before pi and T, or a formula (see expression_text.hpp). Throws libration::error with the reason if the
/// text is invalid.
exact read_exact(std::string_view text);

/// An integer or fraction as an exact number.
inline exact exactly(const rational& value) { return {value, unit::one, value.str()}; }

/// Sums, differences, products and quotients, exactly; their text is a formula of the texts.
exact operator+(const exact& a, const exact& b);
exact operator-(const exact& a, const exact& b);
exact operator*(const exact& a, const exact& b);
exact operator/(const exact& a, const exact& b);

/// -1, 0 or 1. Throws error of the kind undecided if no precision decides, error for multiples
/// of the period.
int sign_of_exact(const exact& number);

/// An exact angle or formula at the working precision: pi is computed with the current precision.
mpfr mpfr_from_exact(const exact& number);

/// The exact number in T, rounded once: pi is computed with 64 more bits than T has.
/// Throws error for multiples of the period, which is defined only for a motion.
template <rounding_scalar T>
T from_exact(const exact& number) {
    if (number.measure == unit::one) {
        return from_rational<T>(number.coefficient);
    }
    mpfr product;
    {
        const precision_scope guard(decimal_digits(digits<T>() + 64));
        product = mpfr_from_exact(number);
    }
    return narrow<T>(product);
}

/// An enclosure of the exact number. Throws error for multiples of the period, which is defined only for a motion.
template <proved_scalar T>
T from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<T>(number.coefficient);
        case unit::period:
            throw error(error_kind::argument, error_subject::number, number.text,
                        "is a multiple of a period, not a number");
        case unit::expression: break;
        case unit::pi:
        case unit::degree: return from_rational<T>(number.in_pi()) * pi<T>();
    }
    if (number.has_periods()) {
        throw error(error_kind::argument, error_subject::number, number.text,
                    "is a multiple of a period, not a number");
    }
    const number_bounds within = number.formula->narrowed(scalar_traits<T>::digits() + 8);
    return scalar_traits<T>::from_bounds(within.lower, within.upper);
}

}  // namespace libration
