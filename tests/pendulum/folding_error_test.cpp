#include "libration/pendulum/folding_error.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_folding_error_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the exact descent is the motion, whatever T* measures it", "[folding_error]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"1.71", "2.02"}) {
        const motion m = with_energy(energy);
        const exact_solution<T> solution(m);
        const T exact_period = effective_period(energy_level_of<T>(m));
        for (const period_rule& by : {period_rule{}, period_rule{period_method::resummed, 2}}) {
            const exact_arc<T> arc(m, by);
            const T period = effective_period_by(by, energy_level_of<T>(m));
            CHECK_THAT(arc(T(0)).value, near<T>(solution.from_top(T(0)).theta, 2));
            const T x = T(1) / 2;
            const pendulum_state<T> expected = solution.from_top(T(x * period / exact_period));
            CHECK_THAT(arc(x).value, near<T>(expected.theta, 4, T(4)));
            CHECK_THAT(arc(x).slope, near<T>(T(expected.omega * period), 4, T(8)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("an exact T* folds without error, another one with its error for each period",
                        "[folding_error]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    const period_rule by{period_method::resummed, 3};
    for (const std::string energy : {"0.1", "8"}) {
        const motion m = with_energy(energy);
        const energy_level<T> o = energy_level_of<T>(m);
        const T off = abs(T(effective_period_by(by, o) - effective_period(o))) * quarters_per_period(o.regime);
        for (const int periods : {0, 3}) {
            const auto none = folding_error<T>(libration::exactly(fraction(energy)), {}, periods, 16);
            CHECK(none.error <= epsilon<T>() * 16 * (8 + abs(none.expected)));
            const auto pair = folding_error<T>(libration::exactly(fraction(energy)), by, periods, 16);
            const T estimate = folding_error_estimate<T>(libration::exactly(fraction(energy)), off, periods);
            // dT is some 1e-6: the next order is dT^2, and the angles round.
            CHECK(abs(T(pair.error - estimate)) <= estimate / 1000 + epsilon<T>() * 16 * (8 + abs(pair.expected)));
            CHECK(abs(T(pair.found - pair.expected)) == pair.error);
        }
    }
    CHECK_THROWS_AS(folding_error<T>(libration::exactly(2), by, 1, 4), libration::error);
}

}  // namespace pendulum_folding_error_test
