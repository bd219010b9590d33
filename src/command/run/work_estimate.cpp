#include "run/work_estimate.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace libration {

work_estimate::work_estimate(std::vector<double> seconds, clock::time_point start)
    : expected_(std::move(seconds)), fractions_(expected_.size(), 0), start_(start) {}

void work_estimate::reached(std::size_t part, double fraction) {
    const std::lock_guard lock(mutex_);
    fractions_.at(part) = std::max(fractions_.at(part), std::min(fraction, 1.0));
}

double work_estimate::seconds_left(clock::time_point now) const {
    const std::lock_guard lock(mutex_);
    const double all = std::accumulate(expected_.begin(), expected_.end(), 0.0);
    const double done = std::inner_product(expected_.begin(), expected_.end(), fractions_.begin(), 0.0);
    const double measured = std::chrono::duration<double>(now - start_).count();
    return (all - done) * (measured + trial_seconds) / (done + trial_seconds);
}

}  // namespace libration
