// Decimal output: the same notation for every scalar, rounded once from the exact binary value.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// Digits and decimal point: 0.d1d2d3... * 10^exponent written as plain or scientific text.
/// Plain from 1e-5 on and while the point falls inside the digits; d.ddde-12 otherwise.
inline std::string place_point(bool negative, std::string digits, long exponent) {
    std::string text;
    if (exponent > static_cast<long>(digits.size()) || exponent < -4) {
        text = digits.substr(0, 1) + (digits.size() > 1 ? "." + digits.substr(1) : "") + "e" +
               std::to_string(exponent - 1);
    } else if (exponent <= 0) {
        text = "0." + std::string(static_cast<std::size_t>(-exponent), '0') + digits;
    } else if (exponent == static_cast<long>(digits.size())) {
        text = std::move(digits);
    } else {
        text = digits.insert(static_cast<std::size_t>(exponent), ".");
    }
    return (negative ? "-" : "") + text;
}

/// x with `count` significant digits, rounded to nearest; 0, inf, -inf and nan as words.
/// Throws error if count < 1.
template <rounding_scalar T>
std::string to_decimal(const T& x, long count) {
    if (count < 1) {
        throw error(error_kind::argument, "number of digits", std::to_string(count), "is less than one");
    }
    const mpfr value = widen(x);
    if (mpfr_nan_p(handle(value)) != 0) {
        return "nan";
    }
    if (mpfr_inf_p(handle(value)) != 0) {
        return mpfr_sgn(handle(value)) < 0 ? "-inf" : "inf";
    }
    if (mpfr_zero_p(handle(value)) != 0) {
        return "0";
    }
    mpfr_exp_t exponent = 0;
    char* raw = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(count), handle(value), MPFR_RNDN);
    std::string digits = raw;
    mpfr_free_str(raw);
    const bool negative = digits.front() == '-';
    return place_point(negative, digits.substr(negative ? 1 : 0), static_cast<long>(exponent));
}

/// "1.5", "1.5 - 2i" of two decimals: the real part alone if the imaginary one is 0.
inline std::string complex_text(const std::string& re, const std::string& im, const std::string& unit = "i") {
    const bool negative = im.starts_with("-");
    return im == "0" ? re : re + (negative ? " - " : " + ") + im.substr(negative ? 1 : 0) + unit;
}

/// log10 |x| with 12 significant digits, -inf for 0: for plots where x is out of range of double.
template <rounding_scalar T>
std::string log10_text(const T& x) {
    constexpr long count = 12;
    const precision_scope scope(count + 20);
    const mpfr value = abs(narrow<mpfr>(widen(x)));
    return value == 0 ? "-inf" : to_decimal(mpfr(log10(value)), count);
}

/// x with as many digits as are needed to recover x exactly when reading it: 1 + ceil(digits log10 2).
template <rounding_scalar T>
std::string to_round_trip(const T& x) {
    if constexpr (std::same_as<T, mpfr>) {
        return to_decimal(x, 1 + decimal_digits(static_cast<long>(mpfr_get_prec(handle(x)))));
    } else {
        return to_decimal(x, 1 + decimal_digits(digits<T>()));
    }
}

/// The decimal expansion of a fraction if it ends within `longest` significant digits.
inline std::optional<std::string> to_finite_decimal(const rational& value, std::size_t longest = 1000) {
    integer denominator = boost::multiprecision::denominator(value);
    long twos = 0;
    long fives = 0;
    for (; denominator % 2 == 0; denominator /= 2) {
        ++twos;
    }
    for (; denominator % 5 == 0; denominator /= 5) {
        ++fives;
    }
    if (denominator != 1) {
        return std::nullopt;
    }
    if (value == 0) {
        return "0";
    }
    const long places = std::max(twos, fives);
    const integer scaled = boost::multiprecision::numerator(
        rational(value * rational(boost::multiprecision::pow(integer(10), static_cast<unsigned>(places)))));
    std::string digits = integer(abs(scaled)).str();
    const long exponent = static_cast<long>(digits.size()) - places;
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.size() > longest) {
        return std::nullopt;
    }
    if (exponent > static_cast<long>(digits.size()) && exponent <= 21) {
        digits.append(static_cast<std::size_t>(exponent) - digits.size(), '0');
    }
    return place_point(value < 0, digits, exponent);
}

}  // namespace libration
