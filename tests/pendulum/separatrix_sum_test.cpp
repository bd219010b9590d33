#include "libration/pendulum/separatrix_sum.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/exact_solution.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_separatrix_sum_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// The first route is correct to 4 ulps (exact_solution_test); the pairs add roundings of random sign, and shrink.
long allowed(long pairs) { return 4 + pairs / 16; }

}  // namespace

TEMPLATE_LIST_TEST_CASE("every motion is a sum of separatrix solutions in scaled time", "[separatrix_sum]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    for (const auto& [name, m] : periodic_motions()) {
        const exact_solution<T> solution(m);
        const separatrix_sum<T> sum(m);
        const T speed = energy_level_of<T>(m).time_scale * 2;  // the scale of omega: the speed of the nearest column
        for (const std::string time : {"0", "0.1", "1", "-13.5", "7.3", "1e6", "T/8", "T/4", "-T/2", "T/3", "7T/9"}) {
            INFO(name << " at " << time);
            const auto s = solution(read_exact(time));
            const auto columns = sum(read_exact(time));
            CHECK_THAT(columns.value, near<T>(s.theta, allowed(sum.pairs()), T(abs(s.theta) + 1)));
            CHECK_THAT(columns.slope, near<T>(s.omega, allowed(sum.pairs()), speed));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("next to E = 2 two pairs of columns are the whole motion", "[separatrix_sum]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(separatrix_sum<T>(with_gap("1e-200")).pairs() <= 4);
    CHECK(separatrix_sum<T>(with_gap("-1e-200")).pairs() <= 4);
}

TEMPLATE_LIST_TEST_CASE("at E = 0 and E = 2 there is no sum", "[separatrix_sum]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(separatrix_sum<T>(with_energy("0")), libration::error);
    CHECK_THROWS_AS(separatrix_sum<T>(with_energy("2")), libration::error);
    CHECK_THROWS_AS(separatrix_sum<T>(with_state("pi", "0")), libration::error);
}

}  // namespace pendulum_separatrix_sum_test
