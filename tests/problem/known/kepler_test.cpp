// Elliptic orbits in closed form, compared with the integration of their equations, and with Kepler's equation solved
// by hand.
#include "libration/problem/known/kepler.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/ode/parse.hpp"
#include "libration/problem/known/proved/kepler.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/text/decimal.hpp"

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

}  // namespace problem_known_kepler_test
