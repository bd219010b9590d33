#include "run/shared_cores.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "run/parallel.hpp"

namespace run_shared_cores_test {

using namespace libration;

namespace {

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

}  // namespace

TEST_CASE("no more steps of all sweeps run at once than there are cores", "[run][shared cores]") {
    constexpr int cores = 2;
    shared_cores shared(cores);
    std::atomic<int> running{0};
    std::atomic<int> most{0};
    std::atomic<int> done{0};
    {
        std::vector<std::jthread> parts;
        for (int rank = 0; rank < 5; ++rank) {
            parts.emplace_back([&, rank] {
                const core_share share(shared, rank);
                on_threads(20, 8, [&](std::size_t) {
                    const int now = ++running;
                    for (int before = most; now > before && !most.compare_exchange_weak(before, now);) {
                    }
                    wait(1);
                    --running;
                    ++done;
                });
            });
        }
    }
    CHECK(done == 100);
    CHECK(most == cores);
}

TEST_CASE("a sweep takes the core that the last step of another leaves over", "[run][shared cores]") {
    // One part has a step that waits for the other part's steps: alone on two cores it would wait in vain.
    shared_cores shared(2);
    std::atomic<int> others{0};
    std::atomic<bool> met{false};
    {
        std::jthread first([&] {
            const core_share share(shared, 0);
            on_threads(1, 2, [&](std::size_t) {
                for (int i = 0; i < 5000 && others < 10; ++i) {
                    wait(1);
                }
                met = others == 10;
            });
        });
        std::jthread second([&] {
            const core_share share(shared, 1);
            on_threads(10, 2, [&](std::size_t) { ++others; });
        });
    }
    CHECK(met);
}

TEST_CASE("of those who wait for a core the lowest rank is next", "[run][shared cores]") {
    shared_cores shared(1);
    shared.take(0);
    std::vector<int> order;
    std::mutex mutex;
    {
        std::vector<std::jthread> waiting;
        for (const int rank : {3, 1, 2}) {
            waiting.emplace_back([&, rank] {
                shared.take(rank);
                {
                    const std::lock_guard lock(mutex);
                    order.push_back(rank);
                }
                shared.give_back();
            });
        }
        wait(50);
        shared.give_back();
    }
    CHECK(order == std::vector<int>{1, 2, 3});
}

TEST_CASE("without a share a sweep has cores of its own", "[run][shared cores]") {
    CHECK(core_share::of_this_thread() == nullptr);
    const core_share::turn core(nullptr);
    core.let_others();
    const core_share::pause waiting(nullptr);
}

}  // namespace run_shared_cores_test
