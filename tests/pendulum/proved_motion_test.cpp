// The two routes of a proved motion compared with each other, with other arithmetic, and at its exact points.
#include "libration/pendulum/proved_motion.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "proved.hpp"

namespace pendulum_proved_motion_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

motion by_energy(const std::string& energy, int direction = 1) {
    return motion::of_energy(read_exact(energy).coefficient, direction);
}
motion by_state(const std::string& theta0, const std::string& omega0) {
    return motion::of_state(read_exact(theta0), read_exact(omega0));
}

}  // namespace

TEST_CASE("the Landen steps and the exact solution in balls enclose the same state", "[pendulum][proved]") {
    const precision_scope scope(60);
    for (const motion& m : {by_energy("1e-6"), by_energy("1.71"), by_energy("1.99999999"), by_energy("2.02"),
                            by_energy("2.02", -1), by_energy("30", -1), by_state("-90deg", "0"), by_state("4pi", "-1"),
                            by_state("3pi", "-0.2"), by_state("0", "-2.5")}) {
        const proved_motion quick(m);
        const exact_solution<ball> slow(m);
        for (const std::string time : {"0", "0.7", "-13", "1000", "T/8", "T/4", "-T/3", "5T/2", "1e9"}) {
            INFO("E = " << m.energy()->str() << ", time " << time);
            const auto first = quick.at(read_exact(time));
            const auto second = slow(read_exact(time));
            CHECK(overlaps(first.theta, second.theta));
            CHECK(overlaps(first.omega, second.omega));
            // 1e9 loses 30 of the 200 bits, and the path near the top a few more.
            CHECK(certainly_less(radius_of(first.theta), ldexp(ball(1), -140)));
        }
    }
}

TEST_CASE("what vanishes by symmetry is the number 0", "[pendulum][proved]") {
    const precision_scope scope(30);
    const auto is_zero = [&](const ball& x) { return is_exact(x) && contains_zero(x); };
    const proved_motion swing(by_state("2.5", "0"));
    CHECK(is_zero(swing.at(read_exact("T/4")).theta));
    CHECK(is_zero(swing.at(read_exact("1e40T")).omega));
    CHECK_FALSE(is_zero(swing.at(read_exact("T/8")).theta));
    const proved_motion turning(by_energy("3", -1));
    CHECK(is_zero(turning.at(read_exact("T/2")).theta));
    CHECK_FALSE(contains_zero(turning.at(read_exact("T")).theta));
    CHECK(is_zero(proved_motion(by_state("pi", "0")).at(read_exact("1e9")).omega));
    CHECK(is_zero(proved_motion(by_energy("0")).at(read_exact("T/3")).theta));
}

TEST_CASE("period and radius have their closed forms in balls", "[pendulum][proved]") {
    const precision_scope scope(60);
    // At E = 1 both are lemniscatic: T* = Gamma(1/4)^2/(4 sqrt pi), R = sqrt(2) T*.
    const proved_motion m(by_energy("1"));
    mpfr gamma;
    mpfr expected;
    {
        const precision_scope more(100);
        gamma = tgamma(mpfr("0.25"));
        expected = gamma * gamma / (sqrt(pi<mpfr>()) * 4);
    }
    // A mean of 10 steps, a division and a square.
    CHECK_THAT(m.effective_period(), encloses({expected, ldexp(mpfr(1), -300)}, 32));
    CHECK(overlaps(m.radius(), sqrt(ball(2)) * m.effective_period()));
    CHECK(overlaps(proved_motion(by_energy("2")).radius(), pi<ball>() / 2));
    CHECK_THROWS_AS(proved_motion(by_energy("2")).effective_period(), libration::error);
    CHECK_THROWS_AS(proved_motion(by_energy("2")).at(read_exact("T/4")), libration::error);
    CHECK_THROWS_AS(proved_motion(by_energy("0")).radius(), libration::error);
}

}  // namespace pendulum_proved_motion_test
