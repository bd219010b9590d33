// The remainder after the nearest columns of singularities, column by column: for the tests of its series.
#pragma once

#include <vector>

#include "libration/pendulum/regime.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::tests {

/// Taylor coefficients of sech about a: s' = -s t, t' = s^2 with t = tanh.
inline std::vector<mpfr> sech_series(const mpfr& a, int order) {
    std::vector<mpfr> s{mpfr(1 / cosh(a))};
    std::vector<mpfr> t{mpfr(tanh(a))};
    for (int n = 0; n < order; ++n) {
        mpfr product(0);
        mpfr square(0);
        for (int k = 0; k <= n; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const auto j = static_cast<std::size_t>(n - k);
            product += s[i] * t[j];
            square += s[i] * s[j];
        }
        s.push_back(mpfr(-product / (n + 1)));
        t.push_back(mpfr(square / (n + 1)));
    }
    return s;
}

/// b_n, n >= 1: a pair has the slope (-1)^p 2 [sech(a + z) - sech(a - z)], in rotation the sum of both. exp(-2 60) ends
/// the columns, or another end.
inline std::vector<mpfr> column_by_column(pendulum::regime r, const mpfr& y, int columns, int order, int end = 60) {
    const bool rotates = r == pendulum::regime::rotation;
    std::vector<mpfr> b(static_cast<std::size_t>(order) + 1, mpfr(0));
    const int last = columns + 3 + static_cast<int>(nearest_integer(mpfr(end / y)));
    for (int p = columns; p < last; ++p) {
        const auto s = sech_series(mpfr(y * (2 * p + 1)), order);
        const int sign = rotates || p % 2 == 0 ? 4 : -4;
        for (int n = rotates ? 1 : 2; n <= order; n += 2) {
            b[static_cast<std::size_t>(n)] += s[static_cast<std::size_t>(n - 1)] * pow(y, n) * sign / n;
        }
    }
    return b;
}

}  // namespace libration::tests
