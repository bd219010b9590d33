// Which coefficients of a list are 0, which must be known before ratios are formed.
//
// Symmetries make every coefficient 0 outside one class n = first mod stride (parity: stride 2). A series whose gaps
// grow has a whole circle of singularities [Hadamard1892: gaps n_{k+1} >= q n_k, q > 1; Fabry1896: n_k/k -> infinity].
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

/// The zero pattern of a_0 .. a_N.
struct coefficient_pattern {
    int order = 0;            ///< N
    int last = -1;            ///< the last nonzero coefficient; -1 if all are 0
    int first = 0;            ///< smallest index of the class that the later coefficients are in
    int stride = 1;           ///< of that class
    int exceptions = 0;       ///< nonzero coefficients outside the class, all in the first quarter
    int zeros = 0;            ///< zero coefficients inside the class, in the last three quarters
    bool lacunary = false;    ///< at most a quarter of the class is nonzero in its second half
    bool polynomial = false;  ///< all coefficients of the second half are 0

    /// As text: "only n = 2 mod 4 are nonzero, with 1 exception in the first quarter".
    std::string text() const {
        if (last < 0) {
            return "all coefficients are 0";
        }
        if (polynomial) {
            return "all coefficients after n = " + std::to_string(last) + " are 0";
        }
        if (lacunary) {
            return "a lacunary series: its gaps grow";
        }
        std::string all = stride == 1   ? "no pattern of zeros"
                          : stride == 2 ? std::string("only ") + (first % 2 == 0 ? "even" : "odd") + " n are nonzero"
                                        : "only n = " + std::to_string(first % stride) + " mod " +
                                              std::to_string(stride) + " are nonzero";
        if (exceptions > 0) {
            all += ", with " + std::to_string(exceptions) + (exceptions == 1 ? " exception" : " exceptions") +
                   " in the first quarter";
        }
        return zeros > 0 ? all + ", and " + std::to_string(zeros) + " further zeros" : all;
    }
};

/// Whether a_n is 0 for a list whose coefficients are known to `noise` of their size: not larger than 64 noise times
/// the largest of its eight neighbours on either side. The list has to be scaled: radius of convergence about 1.
template <rounding_scalar T>
std::vector<bool> zeros_of(const series::power_series<T>& a, const T& noise) {
    using std::abs;
    constexpr int neighbours = 8;
    constexpr int roundings = 64;
    std::vector<bool> zero;
    zero.reserve(a.coefficients().size());
    for (int n = 0; n <= a.order(); ++n) {
        T largest(0);
        for (int m = std::max(0, n - neighbours); m <= std::min(a.order(), n + neighbours); ++m) {
            largest = abs(a[m]) > largest ? T(abs(a[m])) : largest;
        }
        zero.push_back(abs(a[n]) <= largest * noise * roundings);
    }
    return zero;
}

/// The pattern of a scaled list. The class is determined from the last three quarters of the coefficients. O(N).
template <rounding_scalar T>
coefficient_pattern pattern_of(const series::power_series<T>& a, const T& noise) {
    const std::vector<bool> zero = zeros_of(a, noise);
    const auto present = [&](int n) { return !zero[static_cast<std::size_t>(n)]; };
    coefficient_pattern found;
    found.order = a.order();
    std::vector<int> late;
    for (int n = 0; n <= a.order(); ++n) {
        if (present(n)) {
            found.last = n;
            if (4 * n >= a.order()) {
                late.push_back(n);
            }
        }
    }
    found.polynomial = 2 * found.last <= a.order();
    if (found.polynomial || late.empty()) {
        return found;
    }
    int stride = 0;
    for (const int n : late) {
        stride = std::gcd(stride, n - late.front());
    }
    // A class is detected only if it has at least three coefficients, none is missing at the end, and none at all if
    // there are few.
    constexpr std::size_t few = 6;
    const int span = stride * static_cast<int>(late.size() - 1);
    const bool complete = late.size() >= few || late.back() - late.front() == span;
    const bool seen = late.size() >= 3 && complete && (stride == 1 || found.last + stride > a.order());
    found.stride = seen ? stride : 1;
    found.first = late.front() % found.stride;
    int in_second_half = 0;
    for (int n = 0; n <= a.order(); ++n) {
        const bool in_class = n % found.stride == found.first;
        found.exceptions += n > 0 && present(n) && !in_class ? 1 : 0;
        found.zeros += in_class && !present(n) && 4 * n >= a.order() ? 1 : 0;
        in_second_half += in_class && present(n) && 2 * n >= a.order() ? 1 : 0;
    }
    found.lacunary = 4 * in_second_half * found.stride < a.order() / 2;
    return found;
}

/// The class of coefficients that the pattern found.
template <rounding_scalar T>
strided_series<T> regular_part(const series::power_series<T>& a, const coefficient_pattern& pattern) {
    return strided_series<T>(a, pattern.first, pattern.stride);
}

}  // namespace libration::convergence
