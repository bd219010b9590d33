// The error norm of the paper's figure "error": the largest difference between an approximation and the exact solution
// from the top to the bottom, t in [0, T*].
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/pendulum/arc_method.hpp"
#include "libration/pendulum/arc_panels.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/rounded_grid.hpp"
#include "libration/pendulum/separatrix_sum.hpp"

namespace libration::pendulum {

/// Decimal digits by which the error of order N is below theta itself, from its rate (T*/R)^N: the digits that a
/// computation must carry in addition to those wanted in the norm. N^-2 and a few digits for the constants are added.
inline long digits_below(const motion& m, int order) {
    const precision_scope scope(20);
    const energy_level<mpfr> o = energy_level_of<mpfr>(m);
    const top_bounds<mpfr> bounds = top_bounds<mpfr>::of(o);
    const mpfr powers = -log10(bounds.rho) * (order + 3) + log10(mpfr(order + 1)) * 3;
    return 8 + static_cast<long>(nearest_integer(powers));
}

/// Error norms of one motion, with the exact solution sampled once. All at the current working precision, which must
/// cover the wanted digits of the norm below theta: add digits_below().
class arc_errors {
public:
    /// Throws error for E = 0 (theta is constant) and E = 2.
    explicit arc_errors(const motion& m)
        : second_route_(m), arc_(arc_of<mpfr>(m)), truth_(arc_), bounds_(top_bounds<mpfr>::of(arc_.level())) {}

    const top_bounds<mpfr>& bounds() const { return bounds_; }
    const fundamental_arc<mpfr>& arc() const { return arc_; }

    /// The norm of order N as a true maximum and the fraction of T* where it is attained.
    norm_at<mpfr> norm(arc_method method, int order) {
        const auto kept = [&](const auto& approximation) {
            return errors_.insert_or_assign({method, order}, error_of(approximation, points_for(order)))
                .first->second.largest;
        };
        return method == arc_method::series ? kept(series_from_top(arc_, order))
                                            : kept(resummation_from_top(arc_, order));
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

    /// The largest error of the same approximation computed in T, over Chebyshev points and the location of the maximum
    /// in exact arithmetic. Theta itself remains in mpfr, at the same x, so all of T's rounding is in the error. If
    /// norm() has been called before, only the points that its errors and T's rounding do not exclude are evaluated.
    template <fixed_scalar T>
    norm_at<mpfr> norm_in(arc_method method, int order, const motion& m, const mpfr& place) {
        const fundamental_arc<T> arc = arc_of<T>(m);
        const auto exact = errors_.find({method, order});
        const auto norm_of_rounded = [&](const auto& approximation) {
            return rounded_norm([&](const T& x) { return widen(approximation.value(x)); }, narrow<T>(place),
                                exact == errors_.end() ? nullptr : &exact->second);
        };
        return method == arc_method::series ? norm_of_rounded(series_from_top(arc, order))
                                            : norm_of_rounded(resummation_from_top(arc, order));
    }

    /// norm_in() for mpfr of that many digits without guard digits: the accuracy attained by the arithmetic itself.
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

    /// The norm of f - theta for any function f of x, computed at the current working precision. Points as for
    /// a polynomial of degree `order`.
    template <class F>
    norm_at<mpfr> norm_of(const F& approximation, int order) {
        return error_of(approximation, points_for(order)).largest;
    }

    /// Enough points to separate the stationary points of a polynomial of degree `order`, more than twice that; each
    /// number of points is such that it includes those of the smaller ones.
    static int points_for(int order) {
        int intervals = 64;
        while (intervals < 2 * order + 10) {
            intervals *= 2;
        }
        return intervals + 1;
    }

    /// norm_of() with the samples from which it was computed, at this many Chebyshev points.
    template <class F>
    sampled_error error_of(const F& approximation, int count) {
        auto points = chebyshev_points(count);
        const std::vector<series::jet<mpfr>> truth = jets_at(points);
        std::vector<series::jet<mpfr>> differences;
        differences.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const series::jet<mpfr> value = approximation(mpfr(points[i]));
            differences.push_back({value.value - truth[i].value, value.slope - truth[i].slope});
        }
        const auto exactly = [this](const mpfr& x) { return truth_.at(x); };
        auto largest = difference_norm<mpfr>(difference(std::cref(approximation), exactly), points, differences);
        return {std::move(points), std::move(differences), std::move(largest)};
    }

    /// The largest error at 1001 Chebyshev points and one additional point, already rounded, of an approximation in any
    /// arithmetic: value(x) returns its value as a wide number. With the exact error of the same approximation, points
    /// are omitted if 64 times the rounding observed at its samples cannot compensate for the distance of the error
    /// from its maximum there.
    template <class T, class F>
    norm_at<mpfr> rounded_norm(const F& value, const T& place, const sampled_error* exact = nullptr) {
        norm_at<mpfr> largest{mpfr(0), mpfr(0)};
        const auto consider = [&](const T& x, const mpfr& theta) {
            const mpfr error = abs(widen(value(x)) - theta);
            if (error > largest.norm) {
                largest = {error, widen(x)};
            }
        };
        const mpfr level = exact == nullptr ? mpfr(0) : exact->largest.norm - 64 * rounding_seen<T>(value, *exact);
        const auto places = grid_.places_above(exact, level);
        grid_.ask(places, truth_);
        for (const std::size_t i : places) {
            consider(T(grid_.points()[i]), grid_.theta(i));
        }
        consider(place, truth_.at(widen(place)).value);
        return largest;
    }

private:
    mpfr second_theta(const mpfr& x) const {
        return truth_.canonical(second_route_.at(phase_from_top<mpfr>(arc_.of(), x, arc_.effective_period())).value);
    }

    // The exact solution at increasing points, computed once at each of them.
    std::vector<series::jet<mpfr>> jets_at(const std::vector<double>& points) {
        std::vector<double> asked;
        std::ranges::copy_if(points, std::back_inserter(asked), [&](double x) { return !jets_.contains(x); });
        auto made = truth_.jets(asked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            jets_.emplace(asked[i], std::move(made[i]));
        }
        std::vector<series::jet<mpfr>> all;
        all.reserve(points.size());
        for (const double x : points) {
            all.push_back(jets_.at(x));
        }
        return all;
    }

    // The largest change of the error at the samples by T's rounding, and at least epsilon of T.
    template <class T, class F>
    mpfr rounding_seen(const F& value, const sampled_error& exact) {
        const std::vector<series::jet<mpfr>> truth = jets_at(exact.points);
        mpfr seen = widen(epsilon<T>());
        for (std::size_t i = 0; i < exact.points.size(); ++i) {
            const mpfr error = widen(value(T(exact.points[i]))) - truth[i].value;
            seen = std::max(seen, mpfr(abs(error - exact.jets[i].value)));
        }
        return seen;
    }

    separatrix_sum<mpfr> second_route_;
    fundamental_arc<mpfr> arc_;
    arc_panels truth_;
    top_bounds<mpfr> bounds_;
    std::map<double, series::jet<mpfr>> jets_;                    ///< theta at the requested points
    std::map<std::pair<arc_method, int>, sampled_error> errors_;  ///< by method and order
    rounded_grid grid_;
};

}  // namespace libration::pendulum
