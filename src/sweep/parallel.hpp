// The engine of a sweep: independent steps on all cores, results in the order of the steps whatever the threads do.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "sweep/progress.hpp"

namespace libration {

/// work(0), ..., work(steps - 1) on `jobs` threads; the results by index. The working precision is thread-local state, so
/// work opens its own scope. The first exception stops the sweep and is thrown here.
template <class Work>
auto parallel_map(std::size_t steps, int jobs, progress& shown, const Work& work) {
    std::vector<decltype(work(std::size_t{0}))> results(steps);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto worker = [&] {
        for (std::size_t i = next++; i < steps; i = next++) {
            try {
                results[i] = work(i);
                shown.step();
            } catch (...) {
                const std::lock_guard lock(failure_mutex);
                failure = failure ? failure : std::current_exception();
                next = steps;
            }
        }
        mpfr_free_cache();
    };
    {
        const std::size_t count = std::min(steps, static_cast<std::size_t>(std::max(jobs, 1)));
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < count; ++i) {
            threads.emplace_back(worker);
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
    return results;
}

}  // namespace libration
