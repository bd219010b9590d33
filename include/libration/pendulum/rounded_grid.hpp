// Where the error of an approximation computed in a scalar that rounds may be largest. At most points of a fine grid it
// cannot be: there the exact error is below its maximum by more than the change by rounding. So theta is computed at
// the other points alone.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/pendulum/arc_panels.hpp"

namespace libration::pendulum {

/// The exact error of an approximation: its jets at increasing points, the ends of [0, 1] included, and its maximum.
struct sampled_error {
    std::vector<double> points;
    std::vector<series::jet<mpfr>> jets;
    norm_at<mpfr> largest;
};

/// For each interval between neighbouring points whether the error may exceed `level` there.
inline std::vector<bool> intervals_above(const sampled_error& error, const mpfr& level) {
    std::vector<bool> above;
    above.reserve(error.points.size());
    for (std::size_t i = 0; i + 1 < error.points.size(); ++i) {
        const mpfr width = mpfr(error.points[i + 1]) - mpfr(error.points[i]);
        above.push_back(may_exceed(level, error.jets[i], error.jets[i + 1], width));
    }
    return above;
}

/// The 1001 Chebyshev points of [0, 1], with theta at those that were requested.
class rounded_grid {
public:
    const std::vector<double>& points() const { return points_; }

    /// The indices in points() at which the error may exceed `level`; all of them if the exact error is not given.
    std::vector<std::size_t> places_above(const sampled_error* error, const mpfr& level) const {
        std::vector<std::size_t> places;
        std::vector<bool> above;
        if (error != nullptr) {
            above = intervals_above(*error, level);
        }
        std::size_t interval = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            while (interval + 1 < above.size() && error->points[interval + 1] < points_[i]) {
                ++interval;
            }
            if (above.empty() || above[interval]) {
                places.push_back(i);
            }
        }
        return places;
    }

    /// theta at these indices, the new ones in one batch.
    void ask(const std::vector<std::size_t>& places, arc_panels& truth) {
        std::vector<std::size_t> asked;
        std::vector<double> at;
        for (const std::size_t i : places) {
            if (!theta_[i]) {
                asked.push_back(i);
                at.push_back(points_[i]);
            }
        }
        const std::vector<mpfr> values = truth.values(at);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            theta_[asked[i]] = values[i];
        }
    }

    /// theta at an index that was requested.
    const mpfr& theta(std::size_t place) const { return theta_[place].value(); }

private:
    std::vector<double> points_ = chebyshev_points(1001);
    std::vector<std::optional<mpfr>> theta_ = std::vector<std::optional<mpfr>>(points_.size());
};

}  // namespace libration::pendulum
