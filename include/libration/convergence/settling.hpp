// Whether a sequence of estimates has settled: its last entries, how far they move, and the resulting estimate.
//
// An error that falls like 1/n^p, p >= 1, moves by (4/3)^p - 1 of itself, at least a third, over the last quarter of n;
// one that oscillates moves by its own size. Tests use four times the movement as uncertainty: calibrated, not proved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::convergence {

/// The last of several estimates, with the smallest and the largest of them.
template <rounding_scalar T>
struct settled_value {
    T value;
    T lowest;
    T highest;

    T moved_late;  ///< the largest distance from the last one within their last half
    T last_steps;  ///< and within the three before the last

    T spread() const { return highest - lowest; }
    /// Four times the spread; or, if the last half moves less than a sixth of it, the error is assumed to keep falling
    /// geometrically: four times moved_late^2/spread, and no less than the last steps.
    T uncertainty() const {
        if (moved_late * 6 < spread()) {
            const T continued = moved_late * moved_late / spread();
            return (continued > last_steps ? continued : last_steps) * 4;
        }
        return spread() * 4;
    }
    /// "-0.31 and 2.1".
    std::string range() const { return to_decimal(lowest, 3) + " and " + to_decimal(highest, 3); }
    /// Whether the entries change sign, or differ by more than a quarter of the last one.
    bool scatters() const {
        using std::abs;
        return lowest * highest <= 0 || !(spread() * 4 <= abs(value));
    }
};

/// A quarter of this number of entries, at least four steps.
inline int settling_window(int count) { return std::min(count, std::max(4, count / 4) + 1); }

/// Of the last quarter of a sequence, which has at least one entry.
template <rounding_scalar T>
settled_value<T> settled_range(const std::vector<T>& last_quarter) {
    using std::abs;
    const auto [low, high] = std::minmax_element(last_quarter.begin(), last_quarter.end());
    const std::size_t count = last_quarter.size();
    const auto moved_since = [&](std::size_t first) {
        T moved(0);
        for (std::size_t i = first; i < count; ++i) {
            const T by = abs(last_quarter[i] - last_quarter.back());
            moved = by > moved ? by : moved;
        }
        return moved;
    };
    return {last_quarter.back(), *low, *high, moved_since(count / 2),
            moved_since(count - std::min<std::size_t>(4, count))};
}

/// Whether x is neither infinite nor NaN: only then is 0 x = 0.
template <rounding_scalar T>
bool is_a_number(const T& x) {
    return T(x * 0) == 0;
}

/// The estimate unchanged if all its numbers are finite, the radius is above 0 and its uncertainty below it; without
/// position or exponent if these are not finite; otherwise no estimate: the sequence has not settled.
template <rounding_scalar T>
radius_estimate<T> if_settled(radius_estimate<T> answer) {
    if (!answer.radius || !is_a_number(*answer.radius) || !(*answer.radius > 0)) {
        return no_estimate<T>(std::move(answer.method), "its estimates are not finite");
    }
    if (!is_a_number(answer.uncertainty) || !(answer.uncertainty < *answer.radius)) {
        return no_estimate<T>(std::move(answer.method), "its estimates do not settle");
    }
    if (answer.position && !(is_a_number(answer.position->re) && is_a_number(answer.position->im))) {
        answer.position.reset();
    }
    if (answer.exponent && !(is_a_number(*answer.exponent) && is_a_number(answer.exponent_uncertainty))) {
        answer.exponent.reset();
        answer.exponent_uncertainty = T(0);
    }
    return answer;
}

}  // namespace libration::convergence
