// The least order N such that from N on the series, or its resummation, has D digits on [0, T*].
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/arc_tails.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The proved order: the least N >= 4 whose bound A (series) or A2 (resummed) is at most 10^-D. Both bounds decrease
/// with N, so from there on no norm exceeds 10^-D.
inline int proved_order(const top_bounds<mpfr>& bounds, arc_method method, long digits) {
    const mpfr goal = pow(mpfr(10), static_cast<int>(-digits));
    const auto enough = [&](int order) {
        return (method == arc_method::series ? bounds.series_norm(order) : bounds.resummation_norm(order)) <= goal;
    };
    int high = 4;
    while (!enough(high)) {
        if (high > 10'000'000) {
            throw error(error_kind::argument, "number of digits", std::to_string(digits), "needs an order above 10^7");
        }
        high *= 2;
    }
    int low = 4;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (enough(middle)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return high;
}

/// D ln 10/ln(R/T*): the order predicted by the rate alone.
inline mpfr predicted_order(const top_bounds<mpfr>& bounds, long digits) {
    return log(mpfr(10)) * static_cast<int>(digits) / -log(bounds.rho);
}

/// The working precision for errors near 10^-D: D below theta, the 20 bits that the recurrence loses by N = 4000 and
/// twice the digits of N, those of sigma_N'(1) before its point. Add the digits wanted in the error.
inline long working_digits_for(const motion& m, long digits) {
    const precision_scope scope(20);
    const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(m));
    return digits + 15 + 2 * static_cast<long>(nearest_integer(log10(mpfr(predicted_order(bounds, digits) + 1000))));
}

/// The order at which the digits are reached.
struct least_order {
    int order;                   ///< N: its norm and those of all larger orders are at most 10^-D
    mpfr norm;                   ///< at N
    std::optional<mpfr> before;  ///< at N - 1, above 10^-D; empty for N = 0
};

/// The search. All orders down from one that theorems A and A2 prove to be sufficient are sampled in long double from
/// the omitted terms; near 10^-D the true maximum in mpfr decides, at the current working precision.
class arc_orders {
public:
    static constexpr long most_digits = 4000;

    /// Throws error for E = 0, E = 2 and more than most_digits digits, which long double cannot hold.
    arc_orders(const motion& m, long digits)
        : truth_(m), arc_(arc_of<mpfr>(m)), bounds_(top_bounds<mpfr>::of(arc_.level())) {
        if (digits > most_digits) {
            throw error(error_kind::argument, "number of digits", std::to_string(digits),
                        "is more than " + std::to_string(most_digits));
        }
        // 5 more digits make the part omitted by the sampling 1e-5 of what it resolves.
        const int highest = std::max(proved_order(bounds_, arc_method::series, digits + 5),
                                     proved_order(bounds_, arc_method::resummed, digits));
        series_ = arc_series(arc_, highest);
        values_ = slopes_ = std::vector<mpfr>(1, mpfr(0));
        values_[0] = series_[0];
        values_.reserve(series_.coefficients().size());
        slopes_.reserve(series_.coefficients().size());
        for (int n = 1; n <= highest; ++n) {
            values_.push_back(values_.back() + series_[n]);
            slopes_.push_back(slopes_.back() + series_[n] * n);
        }
    }

    const top_bounds<mpfr>& bounds() const { return bounds_; }

    /// One result for each number of digits, in decreasing order. O(N^(3/2)) samples and O(N) for each true maximum.
    std::vector<least_order> least(arc_method method, const std::vector<int>& falling_digits) const {
        std::vector<long double> narrow_series;
        narrow_series.reserve(series_.coefficients().size());
        for (const mpfr& a : series_.coefficients()) {
            narrow_series.push_back(narrow<long double>(a));
        }
        const std::vector<double> points = sample_points();
        arc_tails<long double> tails(std::move(narrow_series), points);
        std::vector<long double> now(points.size());
        std::vector<long double> above(points.size());
        std::vector<least_order> found;
        found.reserve(falling_digits.size());
        std::optional<mpfr> norm_above;
        while (found.size() < falling_digits.size()) {
            tails.errors(method, now);
            const std::optional<mpfr> norm =
                norm_if_near(method, tails.order(), points, now, falling_digits[found.size()]);
            while (norm && found.size() < falling_digits.size() && *norm > level(falling_digits[found.size()])) {
                if (!norm_above) {
                    norm_above = true_norm(method, tails.order() + 1, points, above);
                }
                found.push_back({tails.order() + 1, *norm_above, norm});
            }
            if (tails.order() == 0) {
                while (found.size() < falling_digits.size()) {
                    found.push_back({0, norm ? *norm : true_norm(method, 0, points, now), std::nullopt});
                }
                break;
            }
            if (found.size() < falling_digits.size()) {
                const int next = next_order(method, tails, now, falling_digits[found.size()]);
                norm_above = next + 1 == tails.order() ? norm : std::nullopt;
                std::swap(now, above);
                tails.step_down_to(next);
            }
        }
        return found;
    }

    /// The largest |sigma_N - theta| or |theta_N - theta| near the points at which samples come within a tenth of their
    /// largest.
    mpfr true_norm(arc_method method, int order, const std::vector<double>& points,
                   const std::vector<long double>& samples) const {
        const long double large = *std::max_element(samples.begin(), samples.end()) * 9 / 10;
        mpfr largest(0);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const bool peak = samples[i] >= large && (i == 0 || samples[i] >= samples[i - 1]) &&
                              (i + 1 == samples.size() || samples[i] >= samples[i + 1]);
            if (peak) {
                const std::vector<double> around(
                    points.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 0 : i - 1),
                    points.begin() + static_cast<std::ptrdiff_t>(std::min(i + 2, points.size())));
                const auto error = [&](const mpfr& x) { return error_at(method, order, x); };
                largest = std::max(largest, difference_norm<mpfr>(error, around).norm);
            }
        }
        return largest;
    }

    /// approximation - theta at a fraction x of T*. O(N).
    series::jet<mpfr> error_at(arc_method method, int order, const mpfr& x) const {
        series::jet<mpfr> at = partial_sum(order, x);
        if (method == arc_method::resummed) {
            const auto i = static_cast<std::size_t>(order);
            const mpfr defect = arc_.bottom().value - values_[i];
            const mpfr tilt = arc_.bottom().slope * arc_.effective_period() - slopes_[i] - defect * (order + 1);
            const mpfr power = pow(x, order);
            const mpfr line = defect + tilt * (x - 1);
            at.value += power * x * line;
            at.slope += power * (line * (order + 1) + x * tilt);
        }
        const auto state = truth_.from_top(x);
        return {at.value - state.theta, at.slope - state.omega * arc_.effective_period()};
    }

private:
    static mpfr level(int digits) { return pow(mpfr(10), -digits); }

    // Chebyshev points without 0, whose spacing next to x = 1 is a third of the width 1/N of the largest peak.
    std::vector<double> sample_points() const {
        const double root = std::sqrt(static_cast<double>(series_.order()));
        std::vector<double> points = chebyshev_points(201 + 8 * static_cast<int>(root));
        points.erase(points.begin());
        return points;
    }

    // At that spacing samples miss a peak by 2% at most; 5% are allowed.
    static bool is_near(long double largest, long double goal) { return largest * 105 / 100 > goal; }

    // The next lower order to examine: that above the first one whose samples may be near, or the next one.
    static int next_order(arc_method method, const arc_tails<long double>& tails,
                          const std::vector<long double>& samples, int digits) {
        const auto goal = narrow<long double>(level(digits));
        long double most = *std::max_element(samples.begin(), samples.end());
        int order = tails.order();
        do {
            --order;
            most += tails.growth(method, order);
        } while (order > 0 && !is_near(most + tails.growth(method, order - 1), goal));
        return order;
    }

    std::optional<mpfr> norm_if_near(arc_method method, int order, const std::vector<double>& points,
                                     const std::vector<long double>& samples, int digits) const {
        const long double largest = *std::max_element(samples.begin(), samples.end());
        return is_near(largest, narrow<long double>(level(digits)))
                   ? std::optional(true_norm(method, order, points, samples))
                   : std::nullopt;
    }

    // sigma_N by Horner's rule in x^2, as every second a_n is 0 (except a_0 = pi in rotation).
    series::jet<mpfr> partial_sum(int order, const mpfr& x) const {
        const int parity = bounds_.parity;
        const mpfr square = x * x;
        series::jet<mpfr> sum{mpfr(0), mpfr(0)};
        for (int n = order - (order % 2 == parity ? 0 : 1); n >= parity; n -= 2) {
            horner_step(sum.slope, square, sum.value);
            horner_step(sum.value, square, series_[n]);
        }
        if (parity == 0) {
            return {sum.value, sum.slope * x * 2};
        }
        return {series_[0] + sum.value * x, sum.value + sum.slope * square * 2};
    }

    exact_solution<mpfr> truth_;
    fundamental_arc<mpfr> arc_;
    top_bounds<mpfr> bounds_;
    series::power_series<mpfr> series_;
    std::vector<mpfr> values_;  ///< sigma_n(1)
    std::vector<mpfr> slopes_;  ///< sigma_n'(1)
};

}  // namespace libration::pendulum
