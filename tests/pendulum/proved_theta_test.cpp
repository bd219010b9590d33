// Proved theta and its condition, compared with closed forms and with the exact solution in other arithmetic.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/proved_theta.hpp"

namespace pendulum_proved_theta_test {

using namespace libration;
using namespace libration::pendulum;

TEST_CASE("proved theta is the exact solution of mpfr, to all of its places", "[pendulum][proved_theta]") {
    const std::vector<std::string> gaps{"1", "0.29", "1e-15", "-1e-15", "-3"};
    for (const std::string& text : gaps) {
        for (const char* instant : {"0.7", "10", "1e6"}) {
            INFO("gap " << text << ", t = " << instant);
            const rational gap = read_exact(text).coefficient;
            const rational energy = 2 - gap;
            const ball theta = proved_theta(energy, gap, read_exact(instant).coefficient, 40);
            const precision_scope scope(60);
            const mpfr other = exact_solution<mpfr>(motion::of_energy(energy))(read_exact(instant)).theta;
            // The other route is correct to a few of its 60 digits times theta, below 1e7 here.
            CHECK(certainly_less(abs(theta - ball(other)), pow(ball(10), -40)));
            CHECK(certainly_less(radius_of(theta), pow(ball(10), -40)));
        }
    }
}

TEST_CASE("at the top the condition is that of arccos(1 - E)", "[pendulum][proved_theta]") {
    const precision_scope scope(60);
    for (const char* text : {"1", "0.29", "1e-8", "1e-300", "1.9"}) {
        INFO("gap " << text);
        const rational gap = read_exact(text).coefficient;
        const rational energy = 2 - gap;
        const mpfr condition = energy_condition(energy, gap, 0);
        // d theta0/dE = 1/sqrt(E(2-E)).
        const mpfr top = acos(from_rational<mpfr>(rational(1 - energy)));
        const mpfr unit = top < 1 ? mpfr(1) : top;
        const mpfr expected = sqrt(from_rational<mpfr>(rational(energy / gap))) / unit;
        CHECK(abs(condition / expected - 1) < mpfr("1e-25"));
    }
}

TEST_CASE("the condition is what a small change of the energy makes of theta", "[pendulum][proved_theta]") {
    // E = 1.71, t = 10, changed by 1e-12 E: the second order of it is below 1e-9 of the first.
    const rational energy(171, 100);
    const rational instant(10);
    const rational changed = energy + energy / rational(1'000'000'000'000);
    const ball before = proved_theta(energy, rational(2 - energy), instant, 50);
    const ball after = proved_theta(changed, rational(2 - changed), instant, 50);
    const precision_scope scope(60);
    const mpfr theta = abs(midpoint_of(before));
    const mpfr unit = theta < 1 ? mpfr(1) : theta;
    const mpfr change = abs(midpoint_of(after - before)) * mpfr("1e12") / unit;
    CHECK(abs(energy_condition(energy, rational(2 - energy), instant) / change - 1) < mpfr("1e-9"));
}

TEST_CASE("a fast rotation from the top feels its energy as pi + sqrt(2E) t does", "[pendulum][proved_theta]") {
    // theta = pi + sqrt(2E) t + O(1/E) at a fixed sqrt(E) t: its slope in log E is sqrt(2E) t/2.
    const rational energy(boost::multiprecision::pow(integer(10), 40U));
    const rational instant = 1 / rational(boost::multiprecision::pow(integer(10), 20U));
    const precision_scope scope(60);
    const mpfr condition = energy_condition(energy, rational(2 - energy), instant);
    const mpfr root = sqrt(mpfr(2));
    CHECK(abs(condition / (root / 2 / (pi<mpfr>() + root)) - 1) < mpfr("1e-30"));
}

TEST_CASE("motions without a period are refused by proved theta", "[pendulum][proved_theta]") {
    CHECK_THROWS_AS(proved_theta(0, 2, 1, 20), libration::error);
    CHECK_THROWS_AS(proved_theta(2, 0, 1, 20), libration::error);
    CHECK_THROWS_AS(proved_theta(1, rational(1, 2), 1, 20), libration::error);
}

}  // namespace pendulum_proved_theta_test
