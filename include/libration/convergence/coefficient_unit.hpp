// A unit of length for a list of coefficients, in which its radius of convergence is about 1, determined from the list
// alone.
//
// a_n itself leaves the range of every fixed scalar: 2.9^-1000 is below that of double. With x = u y the list a_n u^n
// stays between powers of n if 1/u is the rate at which |a_n| falls. That rate is the slope of log2 |a_n| over the
// second half of the list.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// x = length y, and a factor 2^-exponent of the whole series, which does not move any singularity.
struct coefficient_unit {
    mpfr length = mpfr(1);
    long exponent = 0;
};

namespace fitting {

/// A point (n, log2 |a_n|).
struct binary_size {
    int n;
    mpfr log_size;
};

/// log2 |a_n| of the nonzero coefficients, n = first .. N.
template <rounding_scalar T>
std::vector<binary_size> binary_sizes(const series::power_series<T>& a, int first) {
    std::vector<binary_size> sizes;
    for (int n = first; n <= a.order(); ++n) {
        if (a[n] != 0) {
            sizes.push_back({n, log2(narrow<mpfr>(mpfr(abs(widen(a[n])))))});
        }
    }
    return sizes;
}

/// The least-squares line through at least two points.
struct size_line {
    mpfr at_middle;
    mpfr middle;
    mpfr slope;
    mpfr operator()(int n) const { return at_middle + (n - middle) * slope; }
};

inline size_line line_through(const std::vector<binary_size>& points) {
    size_line line{mpfr(0), mpfr(0), mpfr(0)};
    for (const auto& p : points) {
        line.middle += p.n;
        line.at_middle += p.log_size;
    }
    line.middle /= points.size();
    line.at_middle /= points.size();
    mpfr square(0);
    for (const auto& p : points) {
        line.slope += (p.n - line.middle) * (p.log_size - line.at_middle);
        square += (p.n - line.middle) * (p.n - line.middle);
    }
    line.slope /= square;
    return line;
}

/// The slope of the upper coefficients: those that nearly cancel, and the rounding errors that represent 0 in a list of
/// decimals, lie far below the others and are ignored.
inline mpfr slope_of_upper(const std::vector<binary_size>& points) {
    constexpr std::size_t fewest = 4;
    const size_line first = line_through(points);
    std::vector<binary_size> upper;
    for (const auto& p : points) {
        if (p.log_size >= first(p.n)) {
            upper.push_back(p);
        }
    }
    return upper.size() < fewest ? first.slope : line_through(upper).slope;
}

}  // namespace fitting

/// The unit of a list: its length has twelve bits, so that it is exact in every scalar, and makes
/// the slope of the second half 0; 1 if fewer than two coefficients are nonzero. The exponent is 0 if the largest
/// coefficient of that half is within 2^100 of 1, since a root test depends on the factor; otherwise it makes that
/// coefficient about 1. The radius need not exist: the unit of an entire function grows with N, that
/// of a divergent series falls. O(N).
template <rounding_scalar T>
coefficient_unit unit_of(const series::power_series<T>& a) {
    constexpr int bits = 12;
    constexpr long far_off = 100;
    const precision_scope scope(40);
    auto points = fitting::binary_sizes(a, a.order() / 2);
    if (points.size() < 2) {
        points = fitting::binary_sizes(a, 0);
    }
    coefficient_unit unit;
    if (points.empty()) {
        return unit;
    }
    if (points.size() > 1) {
        unit.length = exp2(mpfr(-fitting::slope_of_upper(points)));
        mpfr_prec_round(handle(unit.length), bits, MPFR_RNDN);
    }
    const mpfr slope = log2(narrow<mpfr>(unit.length));
    mpfr largest = points.front().log_size + points.front().n * slope;
    for (const auto& p : points) {
        largest = std::max(largest, mpfr(p.log_size + p.n * slope));
    }
    const long exponent = mpfr_get_si(handle(largest), MPFR_RNDN);
    unit.exponent = std::labs(exponent) > far_off ? exponent : 0;
    return unit;
}

/// a_n u^n 2^-exponent, each rounded once to T; the powers have 20 more digits. O(N). Throws error of the kind range if
/// T cannot represent one of them.
template <rounding_scalar T>
series::power_series<T> in_unit_of(const series::power_series<mpfr>& a, const coefficient_unit& unit) {
    std::vector<mpfr> scaled;
    {
        const precision_scope scope(decimal_digits(digits<T>()) + 20);
        scaled.reserve(a.coefficients().size());
        mpfr power = ldexp(mpfr(1), static_cast<int>(-unit.exponent));
        for (int n = 0; n <= a.order(); ++n) {
            scaled.push_back(a[n] * power);
            power *= unit.length;
        }
    }
    std::vector<T> rounded;
    rounded.reserve(scaled.size());
    for (const mpfr& value : scaled) {
        // One exponent is reserved for rounding up.
        const long exponent = value == 0 ? 0 : mpfr_get_exp(handle(value));
        if (!holds_exponent<T>(exponent) || !holds_exponent<T>(exponent + 1)) {
            throw error(error_kind::range,
                        "coefficient " + std::to_string(rounded.size()) + " in the unit " + to_decimal(unit.length, 4) +
                            " of the list",
                        "", "is outside the range of the scalar");
        }
        rounded.push_back(narrow<T>(value));
    }
    return series::power_series<T>(std::move(rounded));
}

}  // namespace libration::convergence
