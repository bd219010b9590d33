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

#include "run/progress.hpp"
#include "run/shared_cores.hpp"

namespace libration {

/// Calls work(0), ..., work(count - 1), each once, on `jobs` threads; where the thread has a core_share, these take the
/// cores of that in turns. The working precision is thread-local state, so work opens its own scope. The first
/// exception stops the rest and is thrown here.
template <class Work>
void on_threads(std::size_t count, int jobs, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    core_share* const share = core_share::of_this_thread();
    const auto worker = [&] {
        const core_share::turn core(share);
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(failure_mutex);
                failure = failure ? failure : std::current_exception();
                next = count;
            }
            core.let_others();
        }
        mpfr_free_cache();
    };
    {
        const core_share::pause waiting(share);
        const std::size_t used = std::min(count, static_cast<std::size_t>(std::max(jobs, 1)));
        std::vector<std::jthread> threads;
        threads.reserve(used);
        for (std::size_t i = 0; i < used; ++i) {
            threads.emplace_back(worker);
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// on_threads() for a sweep: the results of work by index; every finished step is shown.
template <class Work>
auto parallel_map(std::size_t steps, int jobs, progress& shown, const Work& work) {
    std::vector<decltype(work(std::size_t{0}))> results(steps);
    on_threads(steps, jobs, [&](std::size_t i) {
        results[i] = work(i);
        shown.step();
    });
    return results;
}

}  // namespace libration
