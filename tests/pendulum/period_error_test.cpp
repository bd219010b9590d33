#include "libration/pendulum/period_error.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_period_error_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("the bounds of T* hold on both sides of E = 2, and the digits below reach the error", "[period_error]") {
    for (const std::string energy : {"1e-3", "0.5", "1.9998", "2.02", "4", "1000"}) {
        const motion m = with_energy(energy);
        for (const int order : {0, 1, 10, 100}) {
            INFO("E = " << energy << ", N = " << order);
            const long below = period_digits_below(m, order);
            const precision_scope precision(below + 20);
            const auto o = energy_level_of<mpfr>(m);
            for (const auto method : {period_method::series, period_method::resummed}) {
                const period_rule rule{method, order};
                const mpfr error = effective_period(o) - effective_period_by(rule, o);
                CHECK(error > 0);
                CHECK(error <= effective_period_bound(rule, o));
                CHECK(error > pow(mpfr(10), static_cast<int>(-below)));
            }
        }
    }
}

TEST_CASE("the mean leaves nothing out", "[period_error]") {
    const auto o = energy_level_of<double>(with_energy("1"));
    CHECK(effective_period_bound(period_rule{}, o) == 0);
}

}  // namespace pendulum_period_error_test
