// (Kold) and (Knew) as ways to the period.
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/period.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_period_resummation_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("the brackets of (Knew) sum to ln 2 with a tail of 1/(8N)", "[paper]") {
    const precision_scope precision(40);
    mpfr binomial = pi<mpfr>() / 2;
    mpfr sum = binomial - 1;
    for (int n = 1; n <= 2000; ++n) {
        binomial *= mpfr(2 * n - 1) * (2 * n - 1) / (mpfr(2 * n) * (2 * n));
        sum += binomial - mpfr(1) / (2 * n + 1);
        if (n == 20 || n == 200 || n == 2000) {
            INFO(n);
            const mpfr tail = log(mpfr(2)) - sum;
            CHECK(abs(tail * 8 * n - 1) < mpfr(1) / n);
        }
    }
}

TEST_CASE("next to E = 2 (Knew) converges like 1/(8N) and (Kold) not at all", "[paper]") {
    const precision_scope precision(80);
    const auto o = energy_level_of<mpfr>(with_gap("1e-30"));
    const mpfr exact_period = effective_period(o);
    for (const int order : {10, 100, 1000}) {
        INFO(order);
        const mpfr new_error = exact_period - effective_period_resummed(o, order);
        CHECK(abs(new_error * 8 * order - 1) < mpfr(1) / order);
        CHECK(exact_period - effective_period_series(o, order) > 30);
    }
}

TEST_CASE("(Knew) is better than (Kold) at every order and energy", "[paper]") {
    const precision_scope precision(80);
    for (const std::string energy : {"0.1", "0.5", "1.71", "1.9998", "2.02", "4", "10"}) {
        const auto o = energy_level_of<mpfr>(with_energy(energy));
        const mpfr exact_period = effective_period(o);
        for (const int order : {0, 1, 5, 20}) {
            INFO("E = " << energy << ", N = " << order);
            CHECK(abs(effective_period_resummed(o, order) - exact_period) <
                  abs(effective_period_series(o, order) - exact_period));
        }
    }
}

}  // namespace paper_period_resummation_test
