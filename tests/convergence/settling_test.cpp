#include "libration/convergence/settling.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_settling_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("a settled sequence tells its range and how its error goes on", "[convergence][settling]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::vector<T> slow;
    std::vector<T> fast;
    slow.reserve(11);
    fast.reserve(11);
    T power(1);
    for (int n = 30; n <= 40; ++n, power /= 4) {
        slow.push_back(T(1 + T(1) / n));
        fast.push_back(T(1 + power / 64));
    }
    const auto a = settled_range(slow);
    CHECK(a.lowest == slow.back());
    CHECK(a.highest == slow.front());
    CHECK_FALSE(a.scatters());
    CHECK(a.uncertainty() * 40 >= 1);
    const auto b = settled_range(fast);
    CHECK(b.uncertainty() < b.spread());
    CHECK(b.uncertainty() >= b.value - 1);
    CHECK(settled_range(std::vector<T>{T(1), T(-1)}).scatters());
    CHECK(settled_range(std::vector<T>{T(2), T(1)}).range() == "1.00 and 2.00");
}

}  // namespace convergence_settling_test
