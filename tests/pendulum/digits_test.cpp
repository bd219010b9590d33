// theta, omega, periods, coefficients and norms to any number of digits, as requested by a C++ user.
#include "libration/pendulum/digits.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/digits_enclosure.hpp"
#include "libration/scalar/error.hpp"

namespace pendulum_digits_test {

using namespace libration;
using namespace libration::pendulum;

namespace {

// The same digits by both interfaces.
template <class Rounded, class Proved>
void check_both(const std::string& expected, const Rounded& by_rounding, const Proved& by_proof) {
    CHECK(by_rounding.text == expected);
    CHECK(by_proof.text == expected);
}

template <class Call>
error refused(const Call& call) {
    try {
        call();
    } catch (const error& problem) {
        return problem;
    }
    return {error_kind::range, "nothing", "", "was refused"};
}

}  // namespace

TEST_CASE("theta(10^12) has 60 digits in one line", "[pendulum][digits]") {
    const given_motion motion{.theta0 = "2.5", .omega0 = "-0.3"};
    // As in README since its first edition, from an exact solution in 80 digits.
    check_both("-1.28977566036974826206862501873454425528011995252167718066505", rounded::theta(motion, "1e12", 60),
               proved::theta(motion, "1e12", 60));
}

TEST_CASE("the lemniscatic period is a quotient of Gamma(1/4)", "[pendulum][digits]") {
    // Gamma(1/4)^2/sqrt(pi) = 7.416298709205487673735401388781040185..., T* a quarter of it [DLMF 23.5.9].
    const given_motion motion{.theta0 = "90deg", .omega0 = "0"};
    check_both("7.4162987092054876737354013887810401849", rounded::period(motion, 38), proved::period(motion, 38));
    check_both("1.8540746773013719184338503471952600462", rounded::effective_period(motion, 38),
               proved::effective_period(motion, 38));
    check_both("inf", rounded::period({.energy = "2"}, 10), proved::period({.energy = "2"}, 10));
}

TEST_CASE("symmetry makes theta and omega exactly 0", "[pendulum][digits]") {
    const given_motion motion{.energy = "1.71"};
    check_both("0", rounded::theta(motion, "T/4", 30), proved::theta(motion, "T/4", 30));
    check_both("0", rounded::omega(motion, "T/2", 30), proved::omega(motion, "T/2", 30));
}

TEST_CASE("energies keep the digits that cancel", "[pendulum][digits]") {
    check_both("1.71", rounded::energy({.energy = "1.71"}, 20), proved::energy({.energy = "1.71"}, 20));
    check_both("1e-30", rounded::gap({.gap = "1e-30"}, 20), proved::gap({.gap = "1e-30"}, 20));
    // cos 1 = 0.54030230586813971740: E = 1 - cos 1.
    check_both("0.45969769413186028260", rounded::energy({.theta0 = "1", .omega0 = "0"}, 20),
               proved::energy({.theta0 = "1", .omega0 = "0"}, 20));
}

TEST_CASE("coefficients are those of the equation", "[pendulum][digits]") {
    // About the top of E = 1: theta = pi/2 - t^2/2 + t^6/240 + ...
    const given_motion motion{.energy = "1"};
    check_both("-0.50000000000000000000", rounded::coefficient(motion, "top", 2, 20),
               proved::coefficient(motion, "top", 2, 20));
    check_both("0", rounded::coefficient(motion, "top", 4, 20), proved::coefficient(motion, "top", 4, 20));
    check_both("0.0041666666666666666667", rounded::coefficient(motion, "top", 6, 20),
               proved::coefficient(motion, "top", 6, 20));
}

TEST_CASE("radii about points", "[pendulum][digits]") {
    // About the top of E = 1 the lemniscate constant, about the bottom of E = 4 the effective period T* itself.
    check_both("2.6220575542921198105", rounded::radius({.energy = "1"}, "top", 20),
               proved::radius({.energy = "1"}, "top", 20));
    const std::string quarter = proved::effective_period({.energy = "4"}, 20).text;
    check_both(quarter, rounded::radius({.energy = "4"}, "bottom", 20), proved::radius({.energy = "4"}, "bottom", 20));
    check_both("inf", rounded::radius({.energy = "0"}, "top", 20), proved::radius({.energy = "0"}, "top", 20));
}

TEST_CASE("a motion is given by formulas too", "[pendulum][digits]") {
    check_both("1.4142135623730950488", rounded::energy({.energy = "sqrt(2)"}, 20),
               proved::energy({.energy = "sqrt(2)"}, 20));
    check_both("7.4162987092054876737", rounded::period({.theta0 = "pi/2", .omega0 = "sqrt(2)-sqrt(2)"}, 20),
               proved::period({.theta0 = "acos(0)", .omega0 = "0"}, 20));
    CHECK(refused([] { rounded::period({.energy = "90deg"}, 20); }).reason() == "has a unit");
    CHECK(refused([] { rounded::period({.theta0 = "T/4+1", .omega0 = "0"}, 20); }).reason() == "is a time");
    CHECK(refused([] { rounded::theta({.energy = "2"}, "T/4+1", 20); }).subject() == "time");
    CHECK(refused([] { rounded::period({.gap = "3"}, 20); }).reason() == "makes the energy negative");
    CHECK(refused([] { rounded::period({.energy = "1", .length = "0", .gravity = "1"}, 20); }).subject() == "length");
}

TEST_CASE("the norm of order 0 of the series is the angle of release", "[pendulum][digits]") {
    // |theta - a_0| is largest at the bottom: a_0 = pi/2 for E = 1.
    const auto norm = [](const auto& f) { return f({.energy = "1"}, arc_method::series, 0, 25); };
    check_both("1.570796326794896619231322", norm(rounded::error_norm), norm(proved::error_norm));
}

TEST_CASE("seconds where there is a length", "[pendulum][digits]") {
    // One second per unit: length = gravity; twice that: 4 times the length.
    const given_motion twice{.energy = "1", .length = "4", .gravity = "1"};
    CHECK(rounded::effective_period(twice, 20).text == "3.7081493546027438369");
    CHECK(proved::effective_period(twice, 20).text == "3.7081493546027438369");
}

TEST_CASE("bad questions say which quantity is wrong", "[pendulum][digits]") {
    const auto unreached = refused([] { rounded::theta({.theta0 = "3", .energy = "0.5"}, "1", 20); });
    CHECK(unreached.kind() == error_kind::argument);
    CHECK(unreached.subject() == "theta0");
    CHECK(unreached.value() == "3");
    const auto no_number = refused([] { proved::theta({.energy = "much"}, "1", 20); });
    CHECK(no_number.subject() == "energy");
    CHECK(no_number.value() == "much");
    CHECK(no_number.reason() == "is not a number");
    CHECK(refused([] { rounded::theta({.energy = "2"}, "T/4", 20); }).subject() == "time");
    CHECK(refused([] { rounded::theta({.energy = "1"}, "30deg", 20); }).reason() == "is an angle");
    CHECK(refused([] { rounded::period({.energy = "1"}, 0); }).subject() == "number of digits");
    CHECK(refused([] { rounded::period({}, 20); }).subject() == "motion");
    CHECK(refused([] { rounded::period({.energy = "1", .gap = "1"}, 20); }).subject() == "gap");
    CHECK(refused([] { proved::error_norm({.energy = "2"}, arc_method::series, 4, 20); }).subject() == "energy");
    CHECK(refused([] { rounded::coefficient({.energy = "2"}, "top", 4, 20); }).subject() == "point");
}

}  // namespace pendulum_digits_test
