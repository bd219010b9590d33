#include "run/parallel.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/decimal.hpp"

namespace sweep_parallel_test {

using namespace libration;

namespace {

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

template <class Work>
auto mapped(std::size_t steps, int jobs, const Work& work) {
    progress shown("test", steps);
    return parallel_map(steps, jobs, shown, work);
}

}  // namespace

TEST_CASE("results come in the order of the steps, whatever the number of jobs", "[sweep][parallel]") {
    // Early steps take longest, so that they finish last.
    const auto late_first = [](std::size_t i) {
        wait(i < 4 ? 10 : 0);
        return std::to_string(i * i);
    };
    const auto one = mapped(40, 1, late_first);
    REQUIRE(one.size() == 40);
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(one[i] == std::to_string(i * i));
    }
    for (const int jobs : {2, 3, 8, 100}) {
        INFO(jobs);
        CHECK(mapped(40, jobs, late_first) == one);
    }
}

TEST_CASE("every step is done once", "[sweep][parallel]") {
    std::vector<std::atomic<int>> times(1000);
    mapped(times.size(), 4, [&](std::size_t i) { return ++times[i]; });
    for (const auto& done : times) {
        CHECK(done == 1);
    }
}

TEST_CASE("no step needs no thread, and fewer jobs than one are one", "[sweep][parallel]") {
    CHECK(mapped(0, 4, [](std::size_t) { return 1; }).empty());
    CHECK(mapped(3, 0, [](std::size_t i) { return i; }) == std::vector<std::size_t>{0, 1, 2});
    CHECK(mapped(3, -5, [](std::size_t i) { return i; }) == std::vector<std::size_t>{0, 1, 2});
}

TEST_CASE("as many steps run at once as there are jobs", "[sweep][parallel]") {
    // Each step waits until all four have begun: with fewer threads none would end, so it gives up after two seconds.
    std::atomic<int> begun{0};
    const auto met = mapped(4, 4, [&](std::size_t) {
        ++begun;
        for (int i = 0; i < 2000 && begun < 4; ++i) {
            wait(1);
        }
        return begun >= 4 ? 1 : 0;
    });
    CHECK(met == std::vector<int>{1, 1, 1, 1});
}

TEST_CASE("an exception stops the sweep and arrives with its type and its words", "[sweep][parallel]") {
    std::atomic<int> begun{0};
    const auto failing = [&](std::size_t i) {
        ++begun;
        if (i == 3) {
            throw std::domain_error("step three");
        }
        return i;
    };
    CHECK_THROWS_AS(mapped(1000, 1, failing), std::domain_error);
    CHECK(begun == 4);
    CHECK_THROWS_WITH(mapped(1000, 4, failing), "step three");
}

TEST_CASE("after an exception the other jobs begin no further steps", "[sweep][parallel]") {
    std::atomic<int> begun{0};
    std::atomic<bool> thrown{false};
    CHECK_THROWS_AS(mapped(1000, 4,
                           [&](std::size_t i) {
                               ++begun;
                               if (i == 0) {
                                   thrown = true;
                                   throw std::runtime_error("stop");
                               }
                               while (!thrown) {
                                   wait(1);
                               }
                               wait(1);  // a thousand of these would take long after the stop
                               return i;
                           }),
                    std::runtime_error);
    CHECK(begun < 1000);
}

TEST_CASE("each step has the precision of its own scope, and the caller keeps its own", "[sweep][parallel]") {
    const precision_scope callers(200);
    const int bits = digits<mpfr>();
    const auto work = [](std::size_t i) {
        const precision_scope own(20 + 10 * static_cast<long>(i));
        wait(1);  // the other worker changes its precision meanwhile
        return pi<mpfr>();
    };
    for (const int jobs : {1, 2, 4}) {
        const auto values = mapped(30, jobs, work);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const precision_scope expected(20 + 10 * static_cast<long>(i));
            INFO("step " << i << " of " << jobs << " jobs");
            CHECK(mpfr_get_prec(handle(values[i])) == digits<mpfr>());
            CHECK(to_round_trip(values[i]) == to_round_trip(pi<mpfr>()));
        }
    }
    CHECK(digits<mpfr>() == bits);
}

}  // namespace sweep_parallel_test
