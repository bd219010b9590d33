// Orbits with limits at both ends that a reversal of time maps to themselves, compared with closed forms.
#include "../src/libration/query/connection/orbit_symmetry.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "../src/libration/query/connection/connection_orbit.hpp"
#include "libration/problem/limit_text.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_orbit_symmetry_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

// With the initial values that the symmetry gives, and the others as unknowns.
connection symmetric(const std::string& text, long digits) {
    const limit_problem of = limit_problem_of(text);
    connection_question question{of.of.equations(), of.unknowns, {}, of.without_guess, digits};
    for (const std::string& each : of.conditions) {
        question.limits.push_back(parse_limit(question.system, each));
    }
    return proved_connection(question);
}

std::vector<std::string> open_in(const std::string& text) { return limit_problem_of(text).unknowns; }

std::string refusal(const std::string& text) {
    try {
        open_in(text);
    } catch (const error& problem) {
        return problem.what();
    }
    return "";
}

}  // namespace

TEST_CASE("connecting orbits without parameters are those of a reversal of time", "[ode][proved]") {
    const precision_scope scope(80);
    const auto value = [](const std::string& text) { return symmetric(text, 30).values.at(0); };
    // 4 atan(tanh(t/2)), and from 0 to 2 pi and back; the middle is pi then.
    CHECK(within_a_unit(value("y'' = -sin(y); y(-inf) = -pi; y(inf) = pi"), ball(2), 30));
    CHECK(within_a_unit(value("y'' = sin(y); y(-inf) = 2*pi; y(inf) = 0"), ball(-2), 30));
    CHECK(within_a_unit(value("y'' = y^3 - y; y(-inf) = -1; y(inf) = 1"), sqrt(ball(1) / ball(2)), 30));
    // 1 + 2 tanh t.
    CHECK(within_a_unit(value("y'' = (y-1)*((y-1)^2-4)/2; y(-inf) = -1; y(inf) = 3"), ball(2), 30));
    // sqrt 2 sech t, and 3/2 sech^2(t/2) as a system of the first order.
    CHECK(within_a_unit(value("y'' = y - y^3; y(-inf) = 0; y(inf) = 0"), sqrt(ball(2)), 30));
    CHECK(within_a_unit(value("x' = v; v' = x - x^2; x(-inf) = 0; v(-inf) = 0; x(inf) = 0; v(inf) = 0"),
                        ball(3) / ball(2), 30));
}

TEST_CASE("a symmetric orbit has both of its halves", "[ode][proved]") {
    const precision_scope scope(70);
    const auto found = symmetric("y'' = (y-1)*((y-1)^2-4)/2; y(-inf) = 3; y(inf) = -1; y(5) = 1", 30);
    REQUIRE(found.orbit);
    CHECK(found.phase == "y(t) + y(10 - t) = y(-inf) + y(inf), which fixes t = 5");
    CHECK(found.proved.ends_with("and, since y(t) + y(10 - t) = y(-inf) + y(inf), to those at -inf"));
    std::vector<ball> times;
    for (const int t : {12, 5, -40, 4, 60, 6}) {
        times.emplace_back(t);
    }
    const auto states = found.orbit->states(times, 200);
    REQUIRE(states);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const ball e = exp((times[i] - 5) * 2);
        const ball tanh = (e - 1) / (e + 1);
        CHECK(overlaps((*states)[i][0], ball(1) - tanh * 2));
        CHECK(overlaps((*states)[i][1], (tanh * tanh - 1) * 2));
        CHECK(certainly_less(radius_of((*states)[i][0]), pow(ball(10), -25L)));
    }
    CHECK(overlaps(found.orbit->limits(-1)[0], ball(3)));
    CHECK(overlaps(found.orbit->limits(1)[0], ball(-1)));
}

// u = 1/(1 + exp(t/sqrt 6)/2)^2, by its phase.
TEST_CASE("an orbit to a node has no unknown", "[ode][proved]") {
    const precision_scope scope(60);
    const auto found = symmetric("u'' + 5/sqrt(6)*u' + u*(1-u) = 0; u(-inf) = 1; u(inf) = 0", 20);
    CHECK(found.values.empty());
    CHECK(found.proved.starts_with("the solution from the unstable manifold at -inf is on the 2-dimensional stable"));
    REQUIRE(found.orbit);
    for (const int t : {-30, 0, 7, 90}) {
        const auto states = found.orbit->states({ball(t)}, 150);
        REQUIRE(states);
        const ball root = ball(1) + exp(ball(t) / sqrt(ball(6))) / 2;
        CHECK(overlaps((*states)[0][0], ball(1) / (root * root)));
    }
}

TEST_CASE("the initial values of a symmetric orbit", "[ode]") {
    using strings = std::vector<std::string>;
    CHECK(open_in("y'' = y - y^3; y(-inf) = 0; y(inf) = 0") == strings{"y(0)"});
    CHECK(open_in("y'' = y^3 - y; y(-inf) = -1; y(inf) = 1; y(2) = 0") == strings{"y'(2)"});
    CHECK(open_in("u'''' = 5*u'' - 4*u - 90*u^2; u(-inf) = 0; u(inf) = 0") == strings{"u(0)", "u''(0)"});
    using Catch::Contains;
    CHECK_THAT(refusal("y'' = y^3 - y; y(-inf) = -1; y(inf) = 1; y(0) = 1/2"), Contains("limits at both ends"));
    CHECK_THAT(refusal("y'' = y - y^3; y(-inf) = 0; y(inf) = 0; y(0) = 1"), Contains("limits at both ends"));
    // Friction, a field without centre, the time in the equation, and limits that are not images of each other.
    CHECK(open_in("y'' = y^3 - y - y'/9; y(-inf) = -1; y(inf) = 1").empty());
    CHECK(open_in("y'' = (y^3 - y)*(3 + y); y(-inf) = -1; y(inf) = 1").empty());
    CHECK(open_in("y'' = t*y - y^3; y(-inf) = 0; y(inf) = 0").empty());
    CHECK(open_in("x' = v; v' = x - x^2; x(-inf) = 0; v(-inf) = 0; x(inf) = 0; v(inf) = 1").empty());
}

TEST_CASE("initial values that are not those of a symmetric orbit have no symmetry", "[ode]") {
    const auto symmetry = [](const std::string& start) {
        const auto separated = with_limits_separated("y'' = y^3 - y; y(-inf) = -1; y(inf) = 1");
        connection_question question{parse(separated.problem + start), {"y'(0)"}, {}, {}, 20};
        for (const std::string& each : separated.limits) {
            question.limits.push_back(parse_limit(question.system, each));
        }
        return symmetry_of(question).has_value();
    };
    CHECK(symmetry("; y(0) = 0; y'(0) = 1"));
    CHECK_FALSE(symmetry("; y(0) = 1/10^30; y'(0) = 1"));
}

}  // namespace query_connection_orbit_symmetry_test
