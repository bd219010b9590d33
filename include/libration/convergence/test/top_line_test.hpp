// The top-line test of Chang and Corliss: the slope of a straight line along the largest coefficients.
//
// log |a_n| = -n log R - (nu + 1) log n + log A + an oscillating term, never above 0: the upper hull of the points (n,
// log |a_n|) has the slope -log R - (nu + 1)/n [ChangCorliss1980]. The slope is that of the chord of the hull over the
// last half of the list between its quarter points, so that a last coefficient in a trough has no effect. Works for any
// number of singularities and for lacunary series; its only weakness is slow convergence.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/convergence/test/root_test.hpp"

namespace libration::convergence {

namespace fitting {

/// Whether b lies on or below the line from a to d.
template <rounding_scalar T>
bool below_chord(const coefficient_size<T>& a, const coefficient_size<T>& b, const coefficient_size<T>& d) {
    return (b.log_size - a.log_size) * (d.n - a.n) <= (d.log_size - a.log_size) * (b.n - a.n);
}

/// The vertices of the smallest concave function above the points begin .. end.
template <rounding_scalar T>
std::vector<coefficient_size<T>> upper_hull(const std::vector<coefficient_size<T>>& points, std::size_t begin,
                                            std::size_t end) {
    std::vector<coefficient_size<T>> hull;
    for (std::size_t i = begin; i <= end; ++i) {
        while (hull.size() >= 2 && below_chord(hull[hull.size() - 2], hull.back(), points[i])) {
            hull.pop_back();
        }
        hull.push_back(points[i]);
    }
    return hull;
}

/// The hull's height over x, within its range.
template <rounding_scalar T>
T height_of(const std::vector<coefficient_size<T>>& hull, const T& x) {
    std::size_t i = 1;
    while (i + 1 < hull.size() && T(hull[i].n) < x) {
        ++i;
    }
    const auto& a = hull[i - 1];
    const auto& b = hull[i];
    return a.log_size + (b.log_size - a.log_size) * (x - a.n) / (b.n - a.n);
}

/// The slope of the top line over the points up to n = end: the last half of them in n, at least three.
template <rounding_scalar T>
T top_line_slope(const std::vector<coefficient_size<T>>& points, int end) {
    std::size_t last = points.size() - 1;
    while (last > 2 && points[last].n > end) {
        --last;
    }
    std::size_t first = last - 2;
    while (first > 0 && 2 * points[first - 1].n >= points[last].n) {
        --first;
    }
    const auto hull = upper_hull(points, first, last);
    const T quarter = T(points[last].n - points[first].n) / 4;
    const T left = height_of(hull, T(points[first].n + quarter));
    const T right = height_of(hull, T(points[last].n - quarter));
    return (right - left) / (quarter * 2);
}

}  // namespace fitting

/// The radius by the top line. The uncertainty is twice the largest difference from the results of seven eighths, three
/// quarters and a half of the list. Needs six nonzero coefficients. O(N).
template <rounding_scalar T>
radius_estimate<T> top_line_test(const strided_series<T>& c) {
    using std::abs;
    using std::exp;
    constexpr int safety = 2;
    const auto sizes = sizes_of(c);
    if (static_cast<int>(sizes.size()) < fitting::fewest_sizes) {
        return too_short<T>("top-line", fitting::fewest_sizes, static_cast<int>(sizes.size()));
    }
    const int end = sizes.back().n;
    radius_estimate<T> result;
    result.method = "top-line";
    const T radius = exp(-fitting::top_line_slope(sizes, end));
    T moved(0);
    for (const int fewer : {end / 8 * 7, end / 4 * 3, end / 2}) {
        const T other = exp(-fitting::top_line_slope(sizes, fewer));
        moved = abs(other - radius) > moved ? T(abs(other - radius)) : moved;
    }
    result.radius = radius;
    result.uncertainty = moved * safety + radius * epsilon<T>() * (safety * (end + 1));
    return if_settled(std::move(result));
}

}  // namespace libration::convergence
