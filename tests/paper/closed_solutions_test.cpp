// The closed solutions that the paper prints, (critical), (subcritical), (supercritical): where they hold.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/pendulum/exact_solution.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_closed_solutions_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// (critical) at 60 digits: -pi + 4 arctan(e^t tan((theta0 + pi)/4)).
mpfr critical(const std::string& theta0, const mpfr& t) {
    return atan(exp(t) * tan((from_exact<mpfr>(read_exact(theta0)) + pi<mpfr>()) / 4)) * 4 - pi<mpfr>();
}

mpfr theta(const motion& m, const std::string& time) { return exact_solution<mpfr>(m)(read_exact(time)).theta; }

}  // namespace

TEST_CASE("paper (critical) holds for omega0 = +2 cos(theta0/2) and every |theta0| < pi", "[paper]") {
    const precision_scope precision(60);
    for (const std::string theta0 : {"0", "1", "-1.3", "90deg", "120deg", "-3", "3.1"}) {
        const motion rising = motion::of_energy_from(2, read_exact(theta0), 1);
        REQUIRE(rising.regime() == regime::separatrix);
        for (const std::string time : {"0", "0.5", "-2", "7.3", "-13.5"}) {
            INFO(theta0 << " at " << time);
            CHECK_THAT(theta(rising, time),
                       near<mpfr>(critical(theta0, from_exact<mpfr>(read_exact(time))), 20, mpfr(4)));
        }
    }
}

TEST_CASE("paper (critical) is not the motion with omega0 = -2 cos(theta0/2)", "[paper]") {
    const precision_scope precision(60);
    const motion falling = motion::of_energy_from(2, read_exact("1"), -1);
    CHECK(abs(theta(falling, "1") - critical("1", mpfr(1))) > 1);
    // Time reversed it is.
    CHECK_THAT(theta(falling, "1"), near<mpfr>(critical("1", mpfr(-1)), 20, mpfr(4)));
}

TEST_CASE("paper (subcritical) holds for theta0 > 0, and with the other sign for theta0 < 0", "[paper]") {
    const precision_scope precision(60);
    const auto m = modulus<mpfr>::from_modulus(sqrt(mpfr("0.855")));
    for (const int time : {0, 1, 2, 5, 9}) {
        const auto v = jacobi(mpfr(time), m);
        const mpfr printed = asin(m.k * v.cn / v.dn) * 2;  // cd = cn/dn
        INFO(time);
        CHECK_THAT(theta(with_energy("1.71"), std::to_string(time)), near<mpfr>(printed, 40, mpfr(4)));
    }
    // From -60deg: E = 1/2, k = 1/2.
    const auto half = modulus<mpfr>::from_modulus(mpfr(1) / 2);
    const auto v = jacobi(mpfr(1), half);
    const mpfr printed = asin(half.k * v.cn / v.dn) * 2;
    CHECK_THAT(theta(with_state("-60deg", "0"), "1"), near<mpfr>(mpfr(-printed), 40, mpfr(4)));
}

TEST_CASE("paper (supercritical) folds beyond |t| = T*, where the unwrapped angle is 2 am", "[paper]") {
    const precision_scope precision(60);
    // omega0 = 3 at the bottom: E = 4.5, k = 2/3, sqrt(E/2) = 3/2.
    const motion m = with_state("0", "3");
    const auto shape = modulus<mpfr>::from_modulus(mpfr(2) / 3);
    const mpfr turning = complete_integral(shape) * 2 / 3;  // T* = 1.2...
    for (const std::string time : {"0.5", "-1", "1.1", "1.3", "2", "-2", "7.3"}) {
        INFO(time);
        const mpfr t = from_exact<mpfr>(read_exact(time));
        const mpfr printed = asin(jacobi(mpfr(t * 3 / 2), shape).sn) * 2;
        const mpfr expected = theta(m, time);
        CHECK((abs(printed - expected) < mpfr("1e-50")) == (abs(t) < turning));
        CHECK_THAT(expected, near<mpfr>(mpfr(amplitude(mpfr(t * 3 / 2), shape) * 2), 10));
    }
}

TEST_CASE("arccos(1 - E) loses the angle of the top at small energies, the pair (E, 2-E) does not", "[paper]") {
    const double angle = exact_solution<double>(with_energy("1e-16"))(read_exact("0")).theta;
    const precision_scope precision(60);
    const mpfr expected = atan2(sqrt(mpfr("1e-16")), sqrt(2 - mpfr("1e-16"))) * 2;
    CHECK_THAT(angle, near<double>(expected_value{expected, mpfr(0)}, 3));
    CHECK(std::abs(std::acos(1 - 1e-16) / angle - 1) > 0.04);
}

}  // namespace paper_closed_solutions_test
