// Periodic orbits of systems with integrals and symmetries compared with closed forms and published digits.
#include "libration/query/shooting/periodic_orbit.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/number/exact_real.hpp"
#include "libration/scalar/error.hpp"

namespace query_shooting_periodic_orbit_test {

using namespace libration;
using namespace libration::ode;

namespace {

periodic_orbit orbit_of(const std::string& text, long digits, bool multipliers = false, const char* period = nullptr) {
    orbit_question question{digits, {}, multipliers};
    if (period != nullptr) {
        question.period = parse_constant(period).constant();
    }
    return proved_periodic_orbit(explicit_system(parse(text)), question);
}

bool begins(const known_value& value, const std::string& digits) {
    return value.decimal && value.decimal->text.starts_with(digits);
}

std::string arenstorf() {
    return "r = ((x + mu)^2 + y^2)^(3/2); s = ((x - 1 + mu)^2 + y^2)^(3/2); "
           "x'' = x + 2*y' - (1 - mu)*(x + mu)/r - mu*(x - 1 + mu)/s; y'' = y - 2*x' - (1 - mu)*y/r - mu*y/s; "
           "x(0) = 0.994; y(0) = 0; x'(0) = 0; y'(0) = -2.0015851; mu = 0.012277471";
}

}  // namespace

// Kepler's third law: the semi-major axis a = 1 for v^2 = 2/r - 1, T = 2 pi a^(3/2).
TEST_CASE("Kepler's ellipse has the period of its axis", "[ode][proved]") {
    const auto orbit = orbit_of(
        "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2); x(0) = 2/5; y(0) = 0; x'(0) = 0; y'(0) = 2", 25, true);
    CHECK(orbit.period.text == "6.283185307179586476925287");
    CHECK(orbit.is_shortest_period);
    CHECK(orbit.multipliers.size() == 4);
    CHECK(std::ranges::all_of(orbit.multipliers, [](const auto& each) { return !each.reason.empty(); }));
}

// T = 4 K(sin^2(1/2)): tests/reference/orbits.py.
TEST_CASE("a pendulum from rest has the period of the elliptic integral", "[ode][proved]") {
    const auto orbit = orbit_of("x'' = -sin(x); x(0) = 1; x'(0) = 0", 20);
    CHECK(orbit.period.text == "6.6999756643704527127");
    CHECK(orbit.held == std::vector<std::string>{"x", "x'"});
}

TEST_CASE("a family without a declared energy is found, and a given period keeps its value", "[ode][proved]") {
    // T = 4 sqrt(2) int_0^1 dx/sqrt(1 - x^4): tests/reference/orbits.py.
    const auto quartic = orbit_of("x' = y; y' = -x^3; x(0) = 1; y(0) = 0", 20);
    CHECK(quartic.period.text == "7.4162987092054876737");
    const auto given = orbit_of("x' = y; y' = -x^3; x(0) = 1; y(0) = 0", 20, false, "7.5");
    CHECK(given.period.text == "7.5000000000000000000");
    // T is proportional to 1/x(0).
    CHECK(given.start[0].text == "0.98883982789406502316");
}

// R. F. Arenstorf; the digits of [HairerNorsettWanner1993, (0.1)].
TEST_CASE("Arenstorf's orbit is found from 8 digits by its reversal of time", "[ode][proved]") {
    const auto orbit = orbit_of(arenstorf(), 20);
    CHECK(orbit.by_reversal);
    CHECK(orbit.start[0].text == "0.99400000000000000000");
    CHECK(orbit.start[1].text == "0");
    CHECK(orbit.start[3].text.starts_with("-2.0015851063790825"));
    CHECK(orbit.period.text.starts_with("17.065216560157962"));
}

// x = r cos, y = r sin with r' = r (1 - r^2), turning once in 2 pi: the multiplier of r is exp(-4 pi).
TEST_CASE("the multipliers of a cycle in closed form", "[ode][proved]") {
    const auto orbit =
        orbit_of("x' = x - y - x*(x^2 + y^2); y' = x + y - y*(x^2 + y^2); x(0) = 1.01; y(0) = 0", 15, true);
    REQUIRE(orbit.multipliers.size() == 2);
    CHECK(orbit.multipliers[0].reason == "the direction of the orbit");
    CHECK(begins(orbit.multipliers[1].real, "3.48734235620900e-6"));
    CHECK(orbit.stability == orbit_stability::attracting);
}

// The same in x = u + v, y = v, where the orbit is oblique to both coordinates at its beginning.
TEST_CASE("the multipliers of a cycle in oblique coordinates", "[ode][proved]") {
    const auto orbit = orbit_of(
        "p = x - 2*y - (x - y)*((x - y)^2 + y^2); q = x - y*((x - y)^2 + y^2); x' = p + q; y' = q; x(0) = 1.01; y(0) = "
        "0",
        15, true);
    CHECK(orbit.period.text == "6.28318530717959");
    REQUIRE(orbit.multipliers.size() == 2);
    CHECK(begins(orbit.multipliers[1].real, "3.48734235620900e-6"));
}

// u = x, v = y - 3 x^2 with the frequency 1/2: the orbit comes near its initial point shortly before it closes.
TEST_CASE("the period is that of the closest of two near returns", "[ode][proved]") {
    const auto orbit = orbit_of("x' = 1/2*(y-3*x^2); y' = -1/2*x+6*x*1/2*(y-3*x^2); x(0) = 3/4; y(0) = 27/16", 15);
    CHECK(orbit.period.text == "12.5663706143592");
}

// The potential x^2/2 + y^2 + x^4/4 + x^3 y: along y = cos(sqrt(2) t), x = 0 variations are u'' = -u, with the multipliers
// exp(+-2 pi i/sqrt(2)).
TEST_CASE("multipliers on the unit circle, and an unknown that is 0", "[ode][proved]") {
    const auto orbit =
        orbit_of("x'' = -x - x^3 - 3*x^2*y; y'' = -2*y - x^3; x(0) = 0; x'(0) = 0; y(0) = 1; y'(0) = 0", 15, true);
    CHECK(orbit.period.text == "4.44288293815837");
    REQUIRE(orbit.multipliers.size() == 4);
    CHECK(begins(orbit.multipliers[2].real, "-0.26625534204"));
    CHECK(orbit.stability == orbit_stability::on_circle);
}

// C. Simo's digits of the eight: period 6.32591398292621 where X^2 + Y^2 = 1.
TEST_CASE("the figure eight is found among its translations, rotations and scalings", "[.][slow][ode][proved]") {
    const auto eight = orbit_of(
        "a = ((x2-x1)^2+(y2-y1)^2)^(3/2); b = ((x3-x1)^2+(y3-y1)^2)^(3/2); c = ((x3-x2)^2+(y3-y2)^2)^(3/2); "
        "x1'' = (x2-x1)/a + (x3-x1)/b; y1'' = (y2-y1)/a + (y3-y1)/b; x2'' = (x1-x2)/a + (x3-x2)/c; "
        "y2'' = (y1-y2)/a + (y3-y2)/c; x3'' = (x1-x3)/b + (x2-x3)/c; y3'' = (y1-y3)/b + (y2-y3)/c; "
        "x1(0) = 0.97; y1(0) = -0.24309; x2(0) = -0.97; y2(0) = 0.24309; x3(0) = 0; y3(0) = 0; "
        "x1'(0) = 0.46620; y1'(0) = 0.43237; x2'(0) = 0.46620; y2'(0) = 0.43237; x3'(0) = -0.93241; y3'(0) = -0.86473",
        12, false, "6.32591398292621");
    CHECK(eight.period.text == "6.32591398293");
    CHECK(eight.integrals.size() == 4);
    CHECK(eight.start[0].text.starts_with("0.9700"));
}

TEST_CASE("orbits that do not close are refused with their nearest return", "[ode][proved]") {
    CHECK_THROWS_WITH(orbit_of("x' = y; y' = -x^3; x(0) = 1; y(0) = 0", 20, false, "30"),
                      Catch::Contains("already returns at time 7.4163"));
    CHECK_THROWS_WITH(orbit_of("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2); x(0) = 1; y(0) = 0; "
                               "x'(0) = 0; y'(0) = 2",
                               20),
                      Catch::Contains("does not return near its initial point"));
}

}  // namespace query_shooting_periodic_orbit_test
