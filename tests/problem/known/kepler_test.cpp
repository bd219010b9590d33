// Elliptic orbits in closed form, compared with the integration of their equations, and with Kepler's equation solved
// by hand.
#include "libration/problem/known/kepler.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/known/kepler_orbit.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"

namespace problem_known_kepler_test {

using namespace libration;

namespace {

const std::string words = "an elliptic orbit of the two-body problem";

std::optional<recognised_kepler> recognised(const std::string& text) {
    return recognise_kepler(ode::explicit_system(ode::parse(text)));
}

}  // namespace

TEST_CASE("elliptic orbits are recognised however they are written, and are those of the integration", "[problem]") {
    for (const char* text :
         {"x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0)=2/5; y(0)=0; x'(0)=0; y'(0)=2",
          "v'' = -3*v/sqrt(u*u+v*v)^3; u'' = -3*u/sqrt(v^2+u^2)^3; u(1)=1; v(1)=-1/2; u'(1)=1/3; v'(1)=-1",
          "x'' + k*x*(x^2+y^2)^(-3/2) = 0; y'' = -k*y/(y^2+x^2)/sqrt(x^2+y^2); k = pi; x(0)=1; y(0)=0; x'(0)=0; "
          "y'(0)=sqrt(pi)"}) {
        CAPTURE(text);
        const auto closed = solve(problem(text));
        const auto general = solve(problem(text), {.general = true});
        REQUIRE(closed->closed_form() == words);
        REQUIRE(general->closed_form().empty());
        REQUIRE(closed->quantities() == general->quantities());
        const answer a = closed->states("-1/2, 1", proved_digits(25));
        const answer b = general->states("-1/2, 1", proved_digits(25));
        for (std::size_t row = 0; row < 2; ++row) {
            for (const std::string& name : closed->quantities()) {
                CHECK(a.at(row, name) == b.at(row, name));
            }
        }
    }
}

TEST_CASE("equations and orbits that are not elliptic ones of the two-body problem are not recognised", "[problem]") {
    const std::string equations = "x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); ";
    CHECK(recognised(equations + "x(0)=1; y(0)=0; x'(0)=0; y'(0)=1.41421"));
    const std::vector<std::string> others{
        equations + "x(0)=1; y(0)=0; x'(0)=0; y'(0)=1.41422",
        equations + "x(0)=1; y(0)=0; x'(0)=0; y'(0)=sqrt(2)",
        equations + "x(0)=1; y(0)=0; x'(0)=1; y'(0)=0",
        equations + "x(0)=1; y(0)=0; x'(0)=0; y'(0)=1; z' = z; z(0)=1",
        "x'' = x/(x^2+y^2)^(3/2); y'' = y/(x^2+y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -x/(x^2+y^2)^(5/2); y'' = -y/(x^2+y^2)^(5/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -x/(x^2+y^2)^(3/2); y'' = -2*y/(x^2+y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -x/(x^2+2*y^2)^(3/2); y'' = -y/(x^2+2*y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -y/(x^2+y^2)^(3/2); y'' = -x/(x^2+y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -x^2/(x*(x^2+y^2)^(3/2)); y'' = -y/(x^2+y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1",
        "x'' = -t*x/(x^2+y^2)^(3/2); y'' = -t*y/(x^2+y^2)^(3/2); x(1)=1; y(1)=0; x'(1)=0; y'(1)=1"};
    for (const std::string& text : others) {
        CAPTURE(text);
        CHECK_FALSE(recognised(text));
    }
}

// t = u - e sin u, x = cos u - e, y = sqrt(1 - e^2) sin u, u = 1, after any number of periods; the digits at t = 1000
// are those of the integration, with --general.
TEST_CASE("an orbit far away is where Kepler's equation puts it", "[problem]") {
    const auto planet = solve(problem("kepler"));
    const request how = proved_digits(30);
    const answer once = planet->states("1-3/5*sin(1)", how);
    const answer later = planet->states("2e30*pi+1-3/5*sin(1)", how);
    const answer exactly = solve(problem("x' = 0; y' = 0; x(0) = cos(1)-3/5; y(0) = 4/5*sin(1)"))->states("0", how);
    for (const char* name : {"x", "y"}) {
        CHECK(once.at(0, name) == exactly.at(0, name));
        CHECK(later.at(0, name) == exactly.at(0, name));
    }
    const answer far = planet->states("1000", proved_digits(20));
    CHECK(far.at(0, "x") == "-0.60273757992408318276");
    CHECK(far.at(0, "y'") == "-0.0021864725532467498838");
    CHECK(far.rigour == "proved");
    const answer start = planet->states("0", how);
    CHECK(start.at(0, "y") == "0");
}

TEST_CASE("a coordinate that is 0 has a bound, and the others their digits", "[problem]") {
    const answer half = solve(problem("kepler"))->states("pi, 1", proved_digits(10));
    CHECK(half.at(0, "x") == "-1.600000000");
    CHECK_THROWS_WITH(half.at(0, "y"), Catch::Contains("do not distinguish from 0"));
    CHECK_FALSE(half.rows[0][2].bound.empty());
    CHECK_FALSE(half.at(1, "y").empty());
}

// Energy and angular momentum, of an orbit with 1 - e = 5e-13.
TEST_CASE("nearly straight orbits keep their invariants", "[problem]") {
    const precision_scope scope(60);
    const ode::planar_state start{ball(1), ball(0), ball(0), pow(ball(10), -6L)};
    const ode::kepler_orbit orbit(ball(1), start);
    for (int k = 1; k < 12; ++k) {
        const auto [x, y, vx, vy] = orbit.after(ball(k) / 7);
        const ball energy = (vx * vx + vy * vy) / 2 - 1 / sqrt(ball(x * x + y * y));
        CHECK(overlaps(x * vy - y * vx, start.vy));
        CHECK(overlaps(energy, start.vy * start.vy / 2 - 1));
        CHECK(certainly_less(radius_of(x), pow(ball(10), -30L)));
    }
}

// u = 1/100 is the root for M = u - e sin u.
TEST_CASE("the root of Kepler's equation is enclosed from any number near it", "[problem]") {
    const precision_scope scope(40);
    const ball e = ball(99) / 100;
    const ball u = ball(1) / 100;
    const ode::kepler_equation of{e, ball(0), u - e * sin(u), lower_bound((1 - e * e) / 2)};
    for (const int permille : {0, 5, 11, 15, 20}) {
        const ball root = of.root_from(mpfr(permille) / 1000);
        CHECK(overlaps(root, u));
        CHECK(certainly_less(radius_of(root), ball(1) / 10));
    }
}

TEST_CASE("a second proof of an orbit is by integration", "[problem]") {
    request how = proved_digits(15);
    how.check = true;
    const auto planet = solve(problem("kepler"));
    CHECK(planet->states("2", how).at(0, "x") == planet->states("2", proved_digits(15)).at(0, "x"));
    how = rounded_digits(15);
    const answer rounded = planet->states("2", how);
    CHECK(rounded.drifts.size() == 1);
    how.integrator = ode::integrator_choice::taylor;
    CHECK_THROWS_WITH(planet->states("2", how), Catch::Contains("is not used by the closed form of " + words));
}

// x = cos u - e, y = sqrt(1 - e^2) sin u, e = 3/5, at t = u - e sin u, u = 1. The derivative of x along a rotation of the
// start (r, 0) with the velocity (0, v), r = 2/5, v = 2, is r dx/dy(0) - v dx/dx'(0) = -y.
TEST_CASE("arithmetic that rounds and derivatives are those of the integration", "[problem]") {
    const precision_scope scope(40);
    const std::string time = "1-3/5*sin(1)";
    const auto planet = solve(problem("kepler"));
    const answer fixed = planet->states(time, {.scalar = {scalar_kind::binary64, 17}});
    CHECK(fixed.rigour == "heuristic");
    // A few steps of Taylor series, with velocities up to 2.
    CHECK(abs(mpfr(fixed.at(0, "x")) - (cos(mpfr(1)) - mpfr(3) / 5)) < 100 * std::numeric_limits<double>::epsilon());
    request how = proved_digits(20);
    how.derivatives = {"y(0)", "x'(0)"};
    const answer derived = planet->states(time, how);
    const mpfr turned = mpfr(derived.at(0, "dx(t)/dy(0)")) * 2 / 5 - mpfr(derived.at(0, "dx(t)/dx'(0)")) * 2 +
                        mpfr(4) / 5 * sin(mpfr(1));
    CHECK(abs(turned) < pow(mpfr(10), -18));
}

// On the circle x = cos t, y = sin t.
TEST_CASE("invariants are compared at every state that is found", "[problem]") {
    const std::string circle = "x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0)=1; y(0)=0; x'(0)=0; y'(0)=1";
    CHECK(solve(problem(circle))->states("1", rounded_digits(15)).drifts.empty());
    CHECK(solve(problem(circle + "; invariant x"))->states("pi/3", rounded_digits(15)).drifts ==
          std::vector<std::string>{"0.500"});
    const precision_scope scope(40);
    const auto planet = solve(problem("kepler"));
    const answer late = planet->states("1e50, 1e80", rounded_digits(15));
    REQUIRE(late.drifts.size() == 2);
    for (const std::string& drift : late.drifts) {
        CHECK(mpfr(drift) < pow(mpfr(10), -15));
    }
    request how = rounded_digits(15);
    how.progress = [](double) { throw error(error_kind::undecided, "the time", "", "is up"); };
    const answer ended = planet->states("1, 2, 3", how);
    CHECK_THROWS_WITH(ended.at(1, "x"), "the time is up");
    REQUIRE(ended.drifts.size() == 3);
    CHECK(mpfr(ended.drifts[0]) < pow(mpfr(10), -15));
    CHECK(ended.drifts[1].empty());
    CHECK(ended.drifts[2].empty());
}

// x = cos(t - 1/64), y = sin(t - 1/64): integration does not distinguish 1e-1200 from 0.
TEST_CASE("a second proof compares what both decide", "[problem]") {
    request how = proved_digits(5);
    how.check = true;
    const auto circle = solve(
        problem("x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0)=cos(1/64); y(0)=-sin(1/64); x'(0)=sin(1/64); "
                "y'(0)=cos(1/64)"));
    REQUIRE(circle->closed_form() == words);
    const answer found = circle->states("1/64, 1/64+1e-1200", how);
    CHECK(found.at(0, "x") == "1.0000");
    CHECK_THROWS_WITH(found.at(0, "x'"), Catch::Contains("do not distinguish from 0"));
    CHECK(found.at(1, "y") == "1.0000e-1200");
    CHECK(found.at(1, "x'") == "-1.0000e-1200");
}

// y = -1e-10245/2 to first order.
TEST_CASE("a state without all of its digits in the last run is undecided", "[problem]") {
    const answer found = solve(problem("kepler"))->states("pi+1e-10245", proved_digits(10));
    CHECK(found.rows[0].empty());
    CHECK_THROWS_WITH(found.at(0, "x"), Catch::Contains("is not decided by 10250 digits"));
}

}  // namespace problem_known_kepler_test
