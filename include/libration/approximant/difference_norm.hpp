// The infinity norm of the difference of two functions on an interval as a true maximum: a grid misses the largest
// difference, so the stationary points between the grid points are found and refined.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// A norm and where it is attained.
template <class T>
struct norm_at {
    T norm;
    T place;
};

/// The scalars for which stationary points are searched. Boost 1.81's TOMS 748 does not compile with float128 in strict
/// C++20; norms of a fixed scalar use the stationary points of mpfr anyway if its rounding does not hide them.
template <class T>
concept bracketed_scalar = rounding_scalar<T> && !std::same_as<T, quad>;

/// count >= 2 Chebyshev points of [0, 1], ends included: (1 - cos(j pi/(count-1)))/2 rounded to double, so that they
/// are exact in every scalar.
/// Throws error if count < 2.
inline std::vector<double> chebyshev_points(int count) {
    if (count < 2) {
        throw error(error_kind::argument, "number of points", std::to_string(count),
                    "is too small: it includes the two ends");
    }
    std::vector<double> points;
    for (int j = 0; j < count; ++j) {
        const double half_angle = j * std::numbers::pi / (2 * (count - 1));
        points.push_back(j == count - 1 ? 1 : std::sin(half_angle) * std::sin(half_angle));
    }
    return points;
}

/// The difference of two functions that return jets.
template <class F, class G>
auto difference(F f, G g) {
    return [f = std::move(f), g = std::move(g)]<class T>(const T& x) {
        const series::jet<T> a = f(x);
        const series::jet<T> b = g(x);
        return series::jet<T>{a.value - b.value, a.slope - b.slope};
    };
}

/// The zero of the slope of `difference` between two points at which the slope has opposite signs, by the bracketing
/// method of [TOMS748] to full working precision.
template <bracketed_scalar T, class F>
T stationary_point(const F& difference, const T& left, const T& right, const series::jet<T>& at_left,
                   const series::jet<T>& at_right) {
    const auto slope = [&](const T& x) { return difference(x).slope; };
    const T resolution = epsilon<T>() * 4;
    const auto close = [&](const T& a, const T& b) {
        using std::abs;
        return abs(b - a) <= resolution;
    };
    std::uintmax_t steps = 200;
    const auto bracket =
        boost::math::tools::toms748_solve(slope, left, right, at_left.slope, at_right.slope, close, steps);
    return (bracket.first + bracket.second) / 2;
}

/// Whether the slope changes sign between two jets.
template <bracketed_scalar T>
bool turns_between(const series::jet<T>& left, const series::jet<T>& right) {
    const bool at_zero = left.slope == 0 || right.slope == 0;
    return !at_zero && (left.slope < 0) != (right.slope < 0);
}

/// The stationary points between neighbouring points at which the slope has opposite signs. `at_points` holds the jets
/// at the points. Two stationary points between the same neighbours are missed: choose the points dense enough.
template <bracketed_scalar T, class F>
std::vector<T> stationary_points(const F& difference, const std::vector<double>& points,
                                 const std::vector<series::jet<T>>& at_points) {
    std::vector<T> places;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (turns_between(at_points[i], at_points[i + 1])) {
            places.push_back(
                stationary_point(difference, T(points[i]), T(points[i + 1]), at_points[i], at_points[i + 1]));
        }
    }
    return places;
}

/// Whether a function with these jets at two points, `width` apart, may exceed `level` between them: the cubic with
/// both jets stays within 4/27 width (the sum of the |slopes|) of the larger value; here width times that sum is
/// allowed. Thus nothing is searched where the difference is far below its maximum or is only rounding error.
template <bracketed_scalar T>
bool may_exceed(const T& level, const series::jet<T>& left, const series::jet<T>& right, const T& width) {
    using std::abs;
    const T rise = (abs(left.slope) + abs(right.slope)) * width;
    return abs(left.value) + rise > level || abs(right.value) + rise > level;
}

/// The largest |difference| over [0, 1]: over the points, whose jets are given, and the stationary points between them
/// that may exceed it. Throws error if the difference is not finite.
template <bracketed_scalar T, class F>
norm_at<T> difference_norm(const F& difference, const std::vector<double>& points,
                           const std::vector<series::jet<T>>& at_points) {
    using std::abs;
    using std::isfinite;
    norm_at<T> largest{T(0), T(points.front())};
    const auto consider = [&](const T& value, const T& place) {
        if (!isfinite(value)) {
            throw error(error_kind::argument, "difference", "", "is not finite at " + to_decimal(place, 20));
        }
        if (abs(value) > largest.norm) {
            largest = {abs(value), place};
        }
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        consider(at_points[i].value, T(points[i]));
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const series::jet<T>& left = at_points[i];
        const series::jet<T>& right = at_points[i + 1];
        const T from(points[i]);
        const T to(points[i + 1]);
        if (turns_between(left, right) && may_exceed(largest.norm, left, right, T(to - from))) {
            const T place = stationary_point(difference, from, to, left, right);
            consider(difference(place).value, place);
        }
    }
    return largest;
}

/// difference_norm() with the jets computed here.
template <bracketed_scalar T, class F>
norm_at<T> difference_norm(const F& difference, const std::vector<double>& points) {
    std::vector<series::jet<T>> at_points;
    at_points.reserve(points.size());
    for (const double x : points) {
        at_points.push_back(difference(T(x)));
    }
    return difference_norm<T>(difference, points, at_points);
}

}  // namespace libration
