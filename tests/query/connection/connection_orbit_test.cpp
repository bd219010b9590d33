// Orbits on the whole line compared with closed forms, and the angle at which their manifolds intersect.
#include "../src/libration/query/connection/connection_orbit.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_orbit_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

connection orbit_of(const std::string& text, const std::string& guess, long digits) {
    return connected(text, {guess}, digits);
}

const std::string front = "u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(0) = 0; u'(0) = 0; u(-inf) = 1; u(inf) = 0";

ball number_named(const connection& of, const std::string& name) {
    for (const connection_number& each : of.more) {
        if (each.name == name) {
            return widened(ball(mpfr(each.value.text)), magnitude(ball(mpfr(each.value.uncertainty))));
        }
    }
    return ball(0);
}

}  // namespace

// u = 1/(1 + exp(t/sqrt 2)): with amplitude -1 at -inf, and 1 at inf.
TEST_CASE("a front on the whole line is its closed form", "[ode][proved]") {
    const precision_scope scope(70);
    const auto found = orbit_of(front, "c=0.3", 30);
    REQUIRE(found.orbit);
    CHECK(found.orbit->quantities() == std::vector<std::string>{"u", "u'"});
    CHECK(found.phase.starts_with("u = u(-inf) - exp(0.707106781186548 t)"));
    CHECK(contains(number_named(found, "amplitude of u"), ball(1)));
    std::vector<ball> times;
    for (const int t : {3, -60, 0, 1, 100, -2, 9}) {  // in any order, on both manifolds and between them
        times.push_back(ball(t) / 3);
    }
    const auto states = found.orbit->states(times, 200);
    REQUIRE(states);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const ball u = ball(1) / (ball(1) + exp(times[i] / sqrt(ball(2))));
        CHECK(overlaps((*states)[i][0], u));
        CHECK(overlaps((*states)[i][1], -u * (ball(1) - u) / sqrt(ball(2))));
        CHECK(certainly_less(radius_of((*states)[i][0]), u * pow(ball(10), -25L)));
    }
    CHECK(overlaps(found.orbit->limits(-1)[0], ball(1)));
    CHECK(is_exact(found.orbit->limits(1)[0]));
}

// With u' = p(u; c): d(p dp/dc)/du = w/(2 u (1 - u)) + u (1 - u)/sqrt 2, w = p dp/dc, from u = 1 and from u = 0. At u = 1/2, t = 0,
// dp/dc = 4 (pi/32 - 1/24) on the unstable manifold and -4 (pi/32 + 1/24) on the stable one, and the orbit has the direction of u.
TEST_CASE("the manifolds of a front intersect at an angle in closed form", "[ode][proved]") {
    const precision_scope scope(50);
    const auto found = orbit_of(front, "c=0.3", 25);
    const ball angle = atan(pi<ball>() / 8 + ball(1) / 6) + atan(pi<ball>() / 8 - ball(1) / 6);
    const ball computed = number_named(found, "angle of intersection");
    CHECK(contains(computed, angle));
    CHECK(certainly_less(radius_of(computed), pow(ball(10), -20L)));
}

// tanh(-t) from the initial point on, and before it.
TEST_CASE("a wall on the half-line and beyond its initial point", "[ode][proved]") {
    const precision_scope scope(60);
    const auto found = orbit_of("y'' = 2*y*(y^2 - 1); y(3) = 0; y(-inf) = 1", "y'(3)=-0.9", 25);
    REQUIRE(found.orbit);
    const std::vector<ball> times{ball(3), ball(0), ball(-20), ball(4)};
    const auto states = found.orbit->states(times, 200);
    REQUIRE(states);
    for (std::size_t i = 0; i < times.size(); ++i) {
        CHECK(overlaps((*states)[i][0], tanh(ball(3) - times[i])));
    }
}

}  // namespace query_connection_orbit_test
