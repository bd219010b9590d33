#include "run/work_estimate.hpp"

#include <catch2/catch.hpp>
#include <chrono>

namespace run_work_estimate_test {

using namespace libration;
using namespace std::chrono_literals;

TEST_CASE("the time left is the expected one at first and the measured one later", "[run][progress]") {
    const auto start = work_estimate::clock::time_point{};
    work_estimate work({60, 30, 10}, start);
    CHECK(work.seconds_left(start) == 100);

    // A loaded machine takes twice as long: after 120 s the part of 60 s is done, and 40 s are expected to take 80.
    work.reached(0, 1);
    const double left = work.seconds_left(start + 120s);
    // Exactly 40 (120 + 3)/(60 + 3), the 3 s being those that count as measured from the start.
    CHECK(left == Approx(40 * 123.0 / 63));
    CHECK(left > 75);

    // It never goes back, and ends at 0.
    work.reached(0, 0.5);
    CHECK(work.seconds_left(start + 120s) == left);
    work.reached(1, 2);
    work.reached(2, 1);
    CHECK(work.seconds_left(start + 200s) == 0);
}

}  // namespace run_work_estimate_test
