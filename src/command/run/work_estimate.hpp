// How long a work of several parts takes still.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <vector>

namespace libration {

/// The parts of a work, each with its expected time in seconds. The remaining time is estimated from the finished parts
/// and the time that they took on this machine in this run: at first the expected times dominate, later the measured
/// ones. Safe to call from several threads.
class work_estimate {
public:
    using clock = std::chrono::steady_clock;

    explicit work_estimate(std::vector<double> seconds, clock::time_point start = clock::now());

    /// Progress of a part, a fraction of 1. A smaller value than before has no effect.
    void reached(std::size_t part, double fraction);

    /// Of all parts together: what is expected of the rest, times measured/expected of what is done; trial_seconds of
    /// the expectation count as measured, so that the first moments say little.
    double seconds_left(clock::time_point now = clock::now()) const;

    static constexpr double trial_seconds = 3;

private:
    std::vector<double> expected_;
    std::vector<double> fractions_;
    clock::time_point start_;
    mutable std::mutex mutex_;
};

}  // namespace libration
