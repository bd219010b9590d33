// An absolute noise floor in a list: if the coefficients come from an FFT or a quadrature, all have an error of the
// same size, and the last ones consist of that error only.
//
// With errors of size F r^-n (r the radius of the sampled circle, 1 for plain coefficients), log |a_n| falls with n
// until it meets the line log F - n log r, and then scatters about it. An exact a_n could do so too, where the
// contribution of a weak distant singularity or an entire part ends: but those satisfy a linear recurrence of few
// terms, which noise does not. The tail is therefore taken for noise only if no such recurrence explains three quarters
// of it.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/coefficient_unit.hpp"

namespace libration::convergence {

/// The floor of a list: a_n is known to about level rate^n, and is not larger than that from n = first on.
struct coefficient_floor {
    int first = 0;
    mpfr level;
    mpfr rate = mpfr(1);
    /// The size of the error of a_n.
    mpfr at(int n) const { return level * pow(rate, n); }
};

namespace fitting {

/// The fraction of the sum of squares of x_p .. x_{W-1} that x_n = c_1 x_{n-1} + ... + c_p x_{n-p} leaves unexplained,
/// c by least squares; 0 if the equations are singular.
inline mpfr unexplained_share(const std::vector<mpfr>& x, int terms) {
    const auto p = static_cast<std::size_t>(terms);
    std::vector<std::vector<mpfr>> normal(p, std::vector<mpfr>(p, mpfr(0)));
    std::vector<mpfr> right(p, mpfr(0));
    mpfr all(0);
    for (std::size_t n = p; n < x.size(); ++n) {
        for (std::size_t i = 0; i < p; ++i) {
            for (std::size_t j = 0; j < p; ++j) {
                normal[i][j] += x[n - 1 - i] * x[n - 1 - j];
            }
            right[i] += x[n - 1 - i] * x[n];
        }
        all += x[n] * x[n];
    }
    const auto c = solve_linear(std::move(normal), right, mpfr(epsilon<mpfr>() * 64));
    if (!c || all == 0) {
        return 0;
    }
    mpfr explained(0);
    for (std::size_t i = 0; i < p; ++i) {
        explained += (*c)[i] * right[i];
    }
    return 1 - explained / all;
}

/// Whether the coefficients first .. N, divided by 2^line, look like noise.
inline bool looks_like_noise(const std::vector<binary_size>& points, const series::power_series<mpfr>& a,
                             const size_line& line) {
    std::vector<mpfr> x;
    x.reserve(points.size());
    for (const auto& p : points) {
        x.push_back(a[p.n] * exp2(mpfr(-line(p.n))));
    }
    const int most = std::min(6, static_cast<int>(x.size()) / 5);
    for (int terms = 1; terms <= most; ++terms) {
        if (unexplained_share(x, terms) * 4 < 1) {
            return false;
        }
    }
    return true;
}

/// The floor from the tail of the list that starts at the point `begin`; std::nullopt if that is not noise, or if fewer
/// than eight coefficients are above it or none exceeds it by a factor of a thousand.
inline std::optional<coefficient_floor> floor_by_tail(const series::power_series<mpfr>& a,
                                                      const std::vector<binary_size>& points, std::size_t begin) {
    constexpr int margin = 3;  // bits between the mean size and the largest of a few
    constexpr int fewest_above = 8;
    constexpr int least_height = 10;
    constexpr std::size_t fewest_sloped = 24;
    const std::vector<binary_size> tail(points.begin() + static_cast<std::ptrdiff_t>(begin), points.end());
    const size_line line = line_through(tail);
    if (!looks_like_noise(tail, a, line)) {
        return std::nullopt;
    }
    const auto height = [&](const binary_size& p) { return mpfr(p.log_size - line(p.n)); };
    const auto is_above = [&](const binary_size& p) { return height(p) > margin; };
    const auto last = std::find_if(points.rbegin(), points.rend(), is_above);
    const auto above = std::count_if(points.begin(), points.end(), is_above);
    const auto highest = std::max_element(points.begin(), points.end(),
                                          [&](const auto& p, const auto& q) { return height(p) < height(q); });
    if (above < fewest_above || height(*highest) < least_height || last->n >= tail.front().n) {
        return std::nullopt;
    }
    // A slope of less than four bits over the tail means a constant floor.
    const bool level = abs(line.slope) * (tail.back().n - tail.front().n) < 4;
    if (!level && tail.size() < fewest_sloped) {
        return std::nullopt;
    }
    return coefficient_floor{last->n + 1, exp2(mpfr((level ? line.at_middle : line(0)) + 1)),
                             level ? mpfr(1) : mpfr(exp2(line.slope))};
}

}  // namespace fitting

/// The floor of a_0 .. a_N if the list ends in noise: from the longest of its last half, quarter and eighth that looks
/// like noise, at least ten coefficients. Not detected if more than a quarter of the tail follows a recurrence by
/// chance, or if the list ends before three successive coefficients are noise. O(N).
inline std::optional<coefficient_floor> floor_of(const series::power_series<mpfr>& a) {
    constexpr std::size_t fewest = 10;
    const precision_scope scope(40);
    const auto points = fitting::binary_sizes(a, 0);
    for (const std::size_t part : {2U, 4U, 8U}) {
        const std::size_t count = std::max(fewest, points.size() / part);
        if (count + 8 > points.size()) {
            return std::nullopt;
        }
        if (auto floor = fitting::floor_by_tail(a, points, points.size() - count)) {
            return floor;
        }
    }
    return std::nullopt;
}

/// The list above its floor: up to the last coefficient that is `times` the floor; earlier coefficients of at most four
/// times the floor are set to 0, since symmetry may leave nothing but noise there.
inline series::power_series<mpfr> above_floor(const series::power_series<mpfr>& a, const coefficient_floor& floor,
                                              int times) {
    int last = floor.first - 1;
    while (last > 0 && abs(a[last]) < floor.at(last) * times) {
        --last;
    }
    auto kept = a.truncated(last);
    for (int n = 0; n <= last; ++n) {
        if (abs(kept[n]) <= floor.at(n) * 4) {
            kept[n] = 0;
        }
    }
    return kept;
}

/// "a noise floor of about 1.1e-16 from n = 53 on is left out".
inline std::string text_of(const coefficient_floor& floor) {
    const std::string rate = floor.rate == 1 ? "" : " times " + to_decimal(floor.rate, 3) + "^n";
    return "a noise floor of about " + to_decimal(floor.level, 2) + rate + " from n = " + std::to_string(floor.first) +
           " on is left out";
}

}  // namespace libration::convergence
