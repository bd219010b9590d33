// The error norm of the paper's figure "error": the largest difference between an approximation and the exact solution
// on the way from the top to the bottom, t in [0, T*].
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/pendulum/arc/bounds.hpp"
#include "libration/pendulum/arc/resummation.hpp"
#include "libration/pendulum/error/arc_method.hpp"
#include "libration/pendulum/error/arc_panels.hpp"
#include "libration/pendulum/solution/expansion_point.hpp"
#include "libration/pendulum/solution/separatrix_sum.hpp"

namespace libration::pendulum {

/// Decimal digits by which the error of order N is below theta itself, from its rate (T*/R)^N: what a computation has
/// to carry beyond the digits wanted in the norm. N^-2 and a few digits for the constants are added.
inline long digits_below(const motion& m, int order) {
    const precision_scope scope(20);
    const energy_level<mpfr> o = energy_level_of<mpfr>(m);
    const top_bounds<mpfr> bounds = top_bounds<mpfr>::of(o);
    const mpfr powers = -log10(bounds.rho) * (order + 3) + log10(mpfr(order + 1)) * 3;
    return 8 + static_cast<long>(nearest_integer(powers));
}

/// Error norms of one motion, with the truth sampled once. All of it at the working precision in force, which has to
/// hold the wanted digits of the norm below theta: add digits_below().
class arc_errors {
public:
    /// Throws error for E = 0 (theta is constant) and E = 2.
    explicit arc_errors(const motion& m)
        : second_route_(m), arc_(arc_of<mpfr>(m)), truth_(arc_), bounds_(top_bounds<mpfr>::of(arc_.level())) {}

    const top_bounds<mpfr>& bounds() const { return bounds_; }
    const fundamental_arc<mpfr>& arc() const { return arc_; }

    /// The norm of order N as a true maximum and the fraction of T* where it is attained.
    norm_at<mpfr> norm(arc_method method, int order) {
        return method == arc_method::series ? norm_of(series_from_top(arc_, order), order)
                                            : norm_of(resummation_from_top(arc_, order), order);
    }

    /// |approximation - theta| at a fraction x of T*, theta by the second route: its agreement with a norm found at x
    /// is what makes that norm "two-method".
    mpfr second_opinion(arc_method method, int order, const mpfr& x) const {
        const mpfr value = method == arc_method::series ? series_from_top(arc_, order)(x).value
                                                        : resummation_from_top(arc_, order)(x).value;
        return abs(value - second_theta(x));
    }

    /// The same for any function of x.
    template <class F>
    mpfr second_opinion_of(const F& approximation, const mpfr& x) const {
        return abs(approximation(x).value - second_theta(x));
    }

    /// The largest error of the same approximation computed in T, over Chebyshev points and the place where the exact
    /// arithmetic has its maximum. Theta itself stays in mpfr, at the same x, so all of T's rounding is in the error.
    template <fixed_scalar T>
    norm_at<mpfr> norm_in(arc_method method, int order, const motion& m, const mpfr& place) {
        const fundamental_arc<T> arc = arc_of<T>(m);
        const auto norm_of_rounded = [&](const auto& approximation) {
            return rounded_norm([&](const T& x) { return widen(approximation.value(x)); }, narrow<T>(place));
        };
        return method == arc_method::series ? norm_of_rounded(series_from_top(arc, order))
                                            : norm_of_rounded(resummation_from_top(arc, order));
    }

    /// The same in mpfr of that many digits and no guard: what the arithmetic itself reaches.
    norm_at<mpfr> norm_in_digits(long digits, arc_method method, int order, const motion& m, const mpfr& place) {
        const auto norm_of_rounded = [&](const auto& approximation, const mpfr& rounded_place) {
            const auto value = [&](const mpfr& x) {
                const precision_scope narrow_scope(digits);
                return approximation.value(narrow<mpfr>(x));
            };
            return this->rounded_norm(value, rounded_place);
        };
        const auto rounded = [digits](const auto& make) {
            const precision_scope narrow_scope(digits);
            return make();
        };
        const mpfr rounded_place = rounded([&] { return narrow<mpfr>(place); });
        const auto arc = rounded([&] { return arc_of<mpfr>(m); });
        return method == arc_method::series
                   ? norm_of_rounded(rounded([&] { return series_from_top(arc, order); }), rounded_place)
                   : norm_of_rounded(rounded([&] { return resummation_from_top(arc, order); }), rounded_place);
    }

    /// The norm of f - theta for any function f of x, made at the working precision in force. Points as for
    /// a polynomial of degree `order`.
    template <class F>
    norm_at<mpfr> norm_of(const F& approximation, int order) {
        const auto points = chebyshev_points(points_for(order));
        const auto& truth = sampled(jets_, points, &arc_panels::jets);
        std::vector<series::jet<mpfr>> differences;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const series::jet<mpfr> value = approximation(mpfr(points[i]));
            differences.push_back({value.value - truth[i].value, value.slope - truth[i].slope});
        }
        const auto exactly = [this](const mpfr& x) { return truth_.at(x); };
        return difference_norm<mpfr>(difference(std::cref(approximation), exactly), points, differences);
    }

    /// The largest error at the Chebyshev points and one more place, which is rounded already, of an approximation in
    /// any arithmetic: value(x) is what it gives, as a wide number.
    template <class T, class F>
    norm_at<mpfr> rounded_norm(const F& value, const T& place) {
        const auto points = chebyshev_points(points_in_rounding_scalars);
        const auto& truth = sampled(values_, points, &arc_panels::values);
        norm_at<mpfr> largest{mpfr(0), mpfr(0)};
        const auto consider = [&](const T& x, const mpfr& theta) {
            const mpfr error = abs(widen(value(x)) - theta);
            if (error > largest.norm) {
                largest = {error, widen(x)};
            }
        };
        for (std::size_t i = 0; i < points.size(); ++i) {
            consider(T(points[i]), truth[i]);
        }
        consider(place, truth_.at(widen(place)).value);
        return largest;
    }

private:
    static constexpr int points_in_rounding_scalars = 1001;

    // Enough points to part the stationary points: at least 251, and more than twice the order.
    static int points_for(int order) { return std::max(251, 2 * order + 11); }

    mpfr second_theta(const mpfr& x) const {
        return truth_.canonical(second_route_.at(phase_from_top<mpfr>(arc_.of(), x, arc_.effective_period())).value);
    }

    // The truth at so many points, made once.
    template <class Value>
    const std::vector<Value>& sampled(std::map<std::size_t, std::vector<Value>>& by_count,
                                      const std::vector<double>& points,
                                      std::vector<Value> (arc_panels::*make)(const std::vector<double>&)) {
        auto& there = by_count[points.size()];
        if (there.empty()) {
            there = (truth_.*make)(points);
        }
        return there;
    }

    separatrix_sum<mpfr> second_route_;
    fundamental_arc<mpfr> arc_;
    arc_panels truth_;
    top_bounds<mpfr> bounds_;
    std::map<std::size_t, std::vector<series::jet<mpfr>>> jets_;
    std::map<std::size_t, std::vector<mpfr>> values_;
};

}  // namespace libration::pendulum
