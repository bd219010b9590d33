// The times at which the solution of a delay differential equation is not analytic.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// t0 and t0 + n_1 d_1 + .. + n_m d_m for delays d_j and integers n_j >= 0, ascending, each once. Between two of them the
/// solution is analytic as long as it exists, if the history is; and a time between them, less a delay, is between two of
/// them or before t0. Equality is decided on the exact numbers: throws error of the kind undecided for two sums that no
/// precision within the limits separates and that do not have the same form (expression::sign).
class breaking_points {
public:
    /// Positive delays.
    breaking_points(const number& start, const std::vector<number>& delays);

    /// Point number k, the start for k = 0; computed at the first call.
    const number& operator[](std::size_t k);

private:
    std::vector<number> delays_;
    std::vector<number> points_;
    std::vector<std::size_t> next_;  // the next point is the least of points_[next_[j]] + delays_[j]
};

}  // namespace libration::ode
