// The traits of the scalars whose precision is part of their type: double, long double and quad.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "libration/scalar/mpfr_traits.hpp"
#include "libration/scalar/quad.hpp"

namespace libration {

/// Common part of the three. Their wide arithmetic is mpfr.
template <class T>
struct fixed_scalar_traits : default_scalar_traits<T> {
    static constexpr bool fixed = true;
    using wide = mpfr;

    static constexpr int digits() { return std::numeric_limits<T>::digits; }

    /// Whether neither below the normal range nor above it.
    static bool holds_exponent(long exponent) {
        return exponent >= std::numeric_limits<T>::min_exponent && exponent <= std::numeric_limits<T>::max_exponent;
    }

    static long binary_exponent(const T& x) {
        using std::frexp;
        int exponent = 0;
        frexp(x, &exponent);
        return x == 0 ? exponent_of_zero : exponent;
    }

    /// Through mpfr with 64 more bits: within half a unit in the last place and 2^-64 of it.
    static T from_rational(const rational& q) {
        const precision_scope guard(decimal_digits(digits() + 64));
        return scalar_traits<T>::narrow(scalar_traits<mpfr>::from_rational(q));
    }
};

/// Common part of the two built-in types.
template <class T>
struct built_in_scalar_traits : fixed_scalar_traits<T> {
    static T pi() { return std::numbers::pi_v<T>; }

    /// Exactly, and in no less than the working precision.
    static mpfr widen(const T& x) {
        const precision_scope enough(std::max(working_digits(), decimal_digits(std::numeric_limits<T>::digits)));
        return mpfr(x);
    }
};

/// sum_i x[i x_step] y[i y_step], i < count, in four partial sums, which compilers vectorise if the steps are 1; there
/// are four whatever the width of a vector, and so the result is always the same. O(count).
template <int x_step, int y_step>
double sum_in_lanes(const double* x, const double* y, int count) {
    constexpr int lanes = 4;
    std::array<double, lanes> sums{};
    const int whole = count - count % lanes;
    for (int i = 0; i < whole; i += lanes) {
        for (int lane = 0; lane < lanes; ++lane) {
            sums[static_cast<std::size_t>(lane)] += x[(i + lane) * x_step] * y[(i + lane) * y_step];
        }
    }
    for (int i = whole; i < count; ++i) {
        sums[static_cast<std::size_t>(i - whole)] += x[i * x_step] * y[i * y_step];
    }
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

template <>
struct scalar_traits<double> : built_in_scalar_traits<double> {
    static double narrow(const mpfr& x) { return mpfr_get_d(handle(x), MPFR_RNDN); }

    /// In lanes over neighbours, otherwise one product after the other.
    static double sum_of_products(const double* x, int x_step, const double* y, int y_step, int count) {
        if (x_step == 1 && (y_step == 1 || y_step == -1)) {
            return y_step == 1 ? sum_in_lanes<1, 1>(x, y, count) : sum_in_lanes<1, -1>(x, y, count);
        }
        double sum(0);
        for (int i = 0; i < count; ++i) {
            sum += x[i * x_step] * y[i * y_step];
        }
        return sum;
    }
};

template <>
struct scalar_traits<long double> : built_in_scalar_traits<long double> {
    static long double narrow(const mpfr& x) { return mpfr_get_ld(handle(x), MPFR_RNDN); }
};

template <>
struct scalar_traits<quad> : fixed_scalar_traits<quad> {
    static quad pi() { return boost::math::constants::pi<quad>(); }

    /// Exactly, and in no less than the working precision.
    static mpfr widen(const quad& x) {
        if (!(boost::multiprecision::isfinite)(x)) {
            return {static_cast<double>(x)};
        }
        const precision_scope enough(
            std::max(working_digits(), decimal_digits(3 * std::numeric_limits<double>::digits)));
        int exponent = 0;
        quad rest = frexp(x, &exponent);
        mpfr sum(0);
        for (int piece = 0; piece < 3; ++piece) {
            const auto head = static_cast<double>(rest);
            rest -= head;
            sum += head;
        }
        return ldexp(sum, exponent);
    }

    /// Rounded to nearest, below the normal range twice.
    static quad narrow(const mpfr& x) {
        if (mpfr_regular_p(handle(x)) == 0) {
            return {mpfr_get_d(handle(x), MPFR_RNDN)};
        }
        mpfr rest = x;
        mpfr_prec_round(handle(rest), digits(), MPFR_RNDN);
        const auto exponent = mpfr_get_exp(handle(rest));
        mpfr_set_exp(handle(rest), 0);
        quad sum = 0;
        for (int piece = 0; piece < 3; ++piece) {
            const double head = mpfr_get_d(handle(rest), MPFR_RNDN);
            mpfr_sub_d(handle(rest), handle(rest), head, MPFR_RNDN);
            sum += head;
        }
        return ldexp(sum, static_cast<int>(exponent));
    }
};

}  // namespace libration
