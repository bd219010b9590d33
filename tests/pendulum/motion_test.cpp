#include "libration/pendulum/motion.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"

namespace pendulum_motion_test {

using namespace libration;
using namespace libration::pendulum;
using libration::tests::fraction;
using libration::tests::with_energy;
using libration::tests::with_gap;
using libration::tests::with_state;

namespace {

regime regime_of(const std::string& theta0, const std::string& omega0) { return with_state(theta0, omega0).regime(); }

// omega0 given by its dimensionless square: omega0 = square with a gravity/length of square.
regime regime_of_square(const std::string& theta0, const rational& square) {
    return motion::of_state(read_exact(theta0), libration::exactly(square), square).regime();
}

motion from_energy(const std::string& energy, const std::string& theta0, int direction = 1) {
    return motion::of_energy_from(fraction(energy), read_exact(theta0), direction);
}

}  // namespace

TEST_CASE("the separatrix is omega0 = +-2 cos(theta0/2), where that is rational", "[motion]") {
    for (const std::string theta0 : {"120deg", "-120deg", "2pi/3", "240deg", "480deg", "-16pi/3"}) {
        INFO(theta0);
        CHECK(regime_of(theta0, "1") == regime::separatrix);
        CHECK(regime_of(theta0, "-1") == regime::separatrix);
        CHECK(with_state(theta0, "-1").direction() == -1);
    }
    CHECK(regime_of("0", "2") == regime::separatrix);
    CHECK(regime_of("4pi", "-2") == regime::separatrix);
}

TEST_CASE("the separatrix through 60 and 90 degrees takes a gravity and a length that square the root", "[motion]") {
    CHECK(regime_of_square("90deg", 2) == regime::separatrix);
    CHECK(regime_of_square("60deg", 3) == regime::separatrix);
    CHECK(regime_of_square("90deg", rational(2 - fraction("1e-50"))) == regime::libration);
    CHECK(regime_of_square("90deg", rational(2 + fraction("1e-50"))) == regime::rotation);
    CHECK(regime_of("60deg", "1.7320508075688772") == regime::libration);  // sqrt 3 = 1.73205080756887729...
    CHECK(regime_of("60deg", "1.7320508075688773") == regime::rotation);
}

TEST_CASE("next to the separatrix the side is decided, however near", "[motion]") {
    for (const std::string small : {"1e-20", "1e-300", "1e-3000"}) {
        INFO(small);
        const auto above = libration::exactly(rational(1 + fraction(small)));
        const auto below = libration::exactly(rational(1 - fraction(small)));
        CHECK(motion::of_state(read_exact("120deg"), above).regime() == regime::rotation);
        CHECK(motion::of_state(read_exact("120deg"), below).regime() == regime::libration);
        CHECK(with_gap(small).regime() == regime::libration);
        CHECK(with_gap("-" + small).regime() == regime::rotation);
    }
    CHECK(with_energy("2").regime() == regime::separatrix);
}

TEST_CASE("at rest the pendulum swings, except at the bottom and on top", "[motion]") {
    CHECK(regime_of("0", "0") == regime::stable_equilibrium);
    CHECK(regime_of("2pi", "0") == regime::stable_equilibrium);
    CHECK(regime_of("-720deg", "0") == regime::stable_equilibrium);
    CHECK(regime_of("180deg", "0") == regime::unstable_equilibrium);
    CHECK(regime_of("-7pi", "0") == regime::unstable_equilibrium);
    CHECK(with_energy("0").regime() == regime::stable_equilibrium);
    CHECK(from_energy("2", "pi").regime() == regime::unstable_equilibrium);
    CHECK(regime_of("3.141592653589793238462643383279502884197", "0") == regime::libration);
    CHECK(regime_of("3.141592653589793238462643383279502884198", "0") == regime::libration);
    CHECK(regime_of("3.141592653589793238462643383279502884197", "1e-39") == regime::rotation);
    CHECK(regime_of("1e-300", "0") == regime::libration);
}

TEST_CASE("starts on a symmetric point are known as its quarter", "[motion]") {
    CHECK(with_energy("1.71").start_quarter() == 1);
    CHECK(with_energy("2.02").start_quarter() == 1);
    CHECK(with_energy("2.02", -1).start_quarter() == -1);
    CHECK(with_energy("2").start_quarter() == 0);
    CHECK(with_state("0", "1").start_quarter() == 0);
    CHECK(with_state("2pi", "-1").start_quarter() == 2);
    CHECK(with_state("0", "-3").start_quarter() == 0);  // rotation: the phase counts in its direction
    CHECK(with_state("1", "0").start_quarter() == 1);
    CHECK(with_state("-1", "0").start_quarter() == -1);
    CHECK(with_state("9.0", "0").start_quarter() == 1);   // 9.0 = 2 pi + 2.7
    CHECK(with_state("100", "0").start_quarter() == -1);  // 100 = 32 pi - 0.5
    CHECK(from_energy("1", "pi/2").start_quarter() == 1);
    CHECK(from_energy("0.5", "-60deg").start_quarter() == -1);
    CHECK_FALSE(with_state("2.5", "-0.3").start_quarter());
    CHECK_FALSE(with_state("120deg", "1").start_quarter());
}

TEST_CASE("rotation through the top starts there whatever its direction and its turns", "[motion]") {
    for (const std::string top : {"pi", "-pi", "3pi", "-5pi", "7pi"}) {
        for (const int direction : {1, -1}) {
            const motion m = with_state(top, direction > 0 ? "1" : "-1");
            INFO(top << " " << direction);
            // theta = 2 pi turns + direction * (odd quarter of 2 am) = 2 pi turns + direction * quarter * pi.
            REQUIRE(m.start_quarter());
            CHECK(rational(m.turns() * 2 + direction * *m.start_quarter()) == fraction(top));
        }
    }
}

TEST_CASE("the direction is the sign of omega0", "[motion]") {
    CHECK(with_state("1", "5").direction() == 1);
    CHECK(with_state("1", "-5").direction() == -1);
    CHECK(with_state("1", "-5").omega0_sign() == -1);
    CHECK(with_state("1", "0").omega0_sign() == 0);
    CHECK(with_energy("3", -1).omega0_sign() == -1);
    CHECK(with_energy("1.9", -1).omega0_sign() == 0);  // no effect where omega is 0
    CHECK(from_energy("1.71", "30deg", -1).omega0_sign() == -1);
}

TEST_CASE("the energy is kept where it is rational", "[motion]") {
    CHECK(with_energy("171/100").energy() == rational(171, 100));
    CHECK(with_state("120deg", "1/2").energy() == rational(13, 8));
    CHECK(with_state("90deg", "0").energy() == rational(1));
    CHECK_FALSE(with_state("1", "0").energy());
    CHECK(from_energy("2", "pi/2").omega0_squared() == rational(2));
    CHECK(from_energy("0.5", "60deg").omega0_squared() == rational(0));
}

TEST_CASE("an energy reaches the angles below its turning point and no other", "[motion]") {
    CHECK_NOTHROW(from_energy("0.5", "60deg"));
    CHECK_THROWS_AS(from_energy("0.4999999999999999999999999", "60deg"), libration::error);
    CHECK_NOTHROW(from_energy("0.5", "1.0471975511965977461542144610931676280657"));  // below pi/3
    CHECK_THROWS_AS(from_energy("0.5", "1.0471975511965977461542144610931676280658"), libration::error);
    CHECK_THROWS_AS(from_energy("0", "1e-100"), libration::error);
    CHECK_NOTHROW(from_energy("0", "2pi"));
    CHECK_NOTHROW(from_energy("2.000001", "180deg"));
    CHECK_THROWS_AS(from_energy("1.999999", "180deg"), libration::error);
}

TEST_CASE("undecidable and impossible motions are refused", "[motion]") {
    CHECK_THROWS_AS(with_state("1", "pi/2"), libration::error);
    CHECK_THROWS_AS(with_state("1", "30deg"), libration::error);
    CHECK_THROWS_AS(with_state("1", "T"), libration::error);
    CHECK_THROWS_AS(with_energy("-1e-300"), libration::error);
    CHECK_THROWS_AS(from_energy("-1", "0"), libration::error);
}

TEST_CASE("units change the clock alone", "[motion]") {
    const motion plain = with_state("2.5", "-0.3");
    const motion slow = plain.with_squared_frequency(rational(1, 4));
    CHECK(slow.squared_frequency().coefficient == rational(1, 4));
    CHECK(slow.regime() == plain.regime());
    CHECK(slow.omega0_squared() == plain.omega0_squared());
    // 0.6 rad/s at gravity/length = 4 is 0.3 dimensionless.
    const motion fast = motion::of_state(read_exact("2.5"), read_exact("-0.6"), 4);
    CHECK(fast.omega0_squared() == plain.omega0_squared());
}

TEST_CASE("motions by formulas are decided at the precision that it takes", "[motion]") {
    const motion near_top = with_state("pi-1e-100", "0");
    CHECK(near_top.regime() == regime::libration);
    CHECK(near_top.turns() == 0);
    CHECK(near_top.start_quarter() == 1);
    CHECK_FALSE(near_top.energy());
    const motion beyond = with_state("3pi+1e-100", "0");
    CHECK(beyond.turns() == 2);
    CHECK(beyond.start_quarter() == -1);
    CHECK(with_state("2pi+sqrt(2)*1e-50", "1").turns() == 1);
    const motion root = motion::of_energy(read_exact("sqrt(2)"));
    CHECK(root.regime() == regime::libration);
    CHECK_FALSE(root.energy());
    CHECK(root.exact_gap()->measure == unit::expression);
    CHECK(motion::of_energy(read_exact("2+exp(-1000)")).regime() == regime::rotation);
    CHECK(motion::of_energy(read_exact("2-1e-10")).energy() == with_energy("1.9999999999").energy());
    const motion at_rest = motion::of_energy_from(read_exact("1-cos(1)"), read_exact("1"));
    CHECK(at_rest.omega0_sign() == 0);
    CHECK(at_rest.start_quarter() == 1);
    CHECK_THROWS_AS(motion::of_energy(read_exact("-exp(-1000)")), libration::error);
    CHECK(motion::of_energy(read_exact("sqrt(2)^2")).regime() == regime::separatrix);
    for (const std::string energy : {"exp(log(2)/2)^2", "sin(1)^2+cos(1)^2-1"}) {
        INFO(energy);
        try {
            motion::of_energy(read_exact(energy));
            FAIL("decided");
        } catch (const error& problem) {
            CHECK(problem.kind() == error_kind::undecided);
        }
    }
}

TEST_CASE("the same motion as a formula and as a decimal is the same", "[motion]") {
    const motion decimal = with_state("2.5", "-0.3");
    const motion formula = with_state("sqrt(2)+2.5-sqrt(2)", "0.3*(1-2)");
    CHECK(formula.theta0()->coefficient == decimal.theta0()->coefficient);
    CHECK(formula.omega0_squared() == decimal.omega0_squared());
    CHECK(formula.condition_bits() == decimal.condition_bits());
}

}  // namespace pendulum_motion_test
