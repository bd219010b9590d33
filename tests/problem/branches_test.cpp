// Which branch of a piecewise right-hand side follows: values by hand, and solutions that are not unique.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"
#include "problem/known_values.hpp"

namespace problem_branches_test {

using namespace libration;
using namespace libration::tests;

TEST_CASE("step functions inside others have the values of their arguments", "[problem][hybrid]") {
    const precision_scope scope(60);
    const mpfr pi = libration::pi<mpfr>();
    check_values({
        {"y' = if(t - floor(t) > 1/2, 1, 0); y(0) = 0", "2", "y", 1},
        {"y' = if(t - floor(t) - 1 > 0, 1, 0); y(0) = 0", "2", "y", 0},
        {"y' = floor(t + 5*heaviside(t - 1/2)); y(0) = 0", "1", "y", mpfr(5) / 2},
        {"x' = 1; x(0) = -3/10; y' = if(t - 2*heaviside(x) > -1/2, 1, 0); y(0) = 0", "1", "y", mpfr(3) / 10},
        {"y' = abs(abs(t - 1)); y(0) = 0", "2", "y", 1},
        {"y' = max(0, 1 - abs(1 - abs(t - 2))); y(0) = 0", "4", "y", 2},
        {"y' = abs(max(t - 1, 1 - t)); y(0) = 0", "3", "y", mpfr(5) / 2},
        {"y' = max(t, 2*sign(x)); x' = -1; x(0) = 3/2; y(0) = 0", "4", "y", mpfr(79) / 8},
        {"y' = floor(t + sign(x)); x' = -1; x(0) = 3/2; y(0) = 0", "3", "y", 3},
        {"x' = -1; y' = abs(abs(x)); x(0) = 1; y(0) = 0", "3", "y", mpfr(5) / 2},
        {"y' = min(sawtooth(t), 0); y(0) = 0", "6*pi", "y", mpfr(-3 * pi / 2)},
        {"y' = if(sawtooth(t) > 0, 1, 0); y(0) = 0", "13", "y", mpfr(2 * pi)},
        {"y' = if(t - 2*floor(t/2) > 1, square(t), 0); y(0) = 0", "9", "y", mpfr(2 * pi - 6)},
        // A bounce whose force changes with the sign of x, which is positive after it.
        {"x'' = -1 - sign(x)/2; x(0) = 1; x'(0) = 0; when x = 0 down: x' = -x'", "2", "x'",
         mpfr(2 * sqrt(mpfr(3)) - 3)},
        // floor of the state: the squares 1, 2, 3 at 1, sqrt 2, sqrt 3.
        {"x' = 1; y' = floor(x^2); x(0) = 0; y(0) = 0", "2", "y", mpfr(5 - sqrt(mpfr(2)) - sqrt(mpfr(3)))},
    });
}

// By hand, piece by piece; a single moment counts for nothing.
TEST_CASE("conditions whose sides touch are those on both sides of the moment", "[problem][hybrid][touching]") {
    const precision_scope scope(60);
    const mpfr two(2);
    const mpfr five(5);
    const mpfr angles = pi<mpfr>() * 5 / 4 - 2 * atan(two) + (log(five) - log(two)) / 2;
    check_values({
        {"y' = if((t - 1)^2 != 0, 1, 0); y(0) = 0", "2", "y", 2},
        {"y' = if((t - 1)^2 == 0, 5, 1); y(0) = 0", "2", "y", 2},
        {"y' = if(t^2 - 2*t + 1 > 0, 1, 0); y(0) = 0", "2", "y", 2},
        {"y' = if((t - 1)^2*(3 - t) > 0, 1, 2); y(0) = 0", "4", "y", 5},
        {"y' = sign((t - 1)^2*(t - 2)); y(0) = 0", "3", "y", -1},
        {"y' = sign(t^3 - 3*t^2 + 3*t - 1); y(0) = 0", "3", "y", 1},
        {"y' = if(1 - cos(t) > 0, 1, 0); y(1) = 0", "7", "y", 6},
        {"y' = if(sin(t) < 1, 1, 0); y(0) = 0", "3", "y", 3},
        {"y' = if(cos(t) < 1, 2, 5); y(-1) = 0", "7", "y", 16},
        {"y' = 1 + floor(2 - (t - 1)^2/2); y(0) = 0", "2", "y", 4},
        {"x' = 1; y' = if((x - 1)^2*(3 - x) > 0, 1, 0); x(0) = 0; y(0) = 0", "4", "y", 3},
        {"x' = 1; y' = if(x^2*(x - 1)^4 >= 0, 1, 0); x(0) = -1; y(0) = 0", "4", "y", 4},
        {"y' = atan2(t - 1, -1); y(0) = 0", "3", "y", angles},
    });
    // Where the square is 0 for some time, its condition is as written.
    check_values({{"y' = if((max(t, 1) - 1)^2 > 0, 1, 3); y(0) = 0", "3", "y", 5},
                  {"y' = sign((max(t, 1) - 1)^2*(t - 4)); y(0) = 0", "3", "y", -2}});
    CHECK_FALSE(refusal("x' = sign(x^2); x(0) = 0", "2").empty());
}

// The sign of an odd power is that of its base.
TEST_CASE("odd powers in conditions have the sign of their bases", "[problem][hybrid][touching]") {
    const precision_scope scope(60);
    check_values({{"y' = if((t-1)^7 > 0, 1, 2); y(0) = 0", "3", "y", mpfr(4)},
                  {"y' = if(x^7 > 0, 1, 2); x' = 1; x(0) = -1; y(0) = 0", "5", "y", mpfr(6)},
                  {"y' = if(-3*(t-1)^7*(t-2)^4 >= 0, 1, 2) + sign((t-3)^3*5); y(0) = 0", "4", "y", mpfr(5)}});
}

TEST_CASE("conditions and outputs without a value at the initial point are named with the reason",
          "[problem][hybrid]") {
    for (const std::string root : {"sqrt(t - 2)^2", "sqrt(t - 2)"}) {
        CHECK(refusal("y' = if(" + root + " > 0, 1, 2); y(0) = 0", "1") ==
              "start 'if(" + root +
                  " > 0, 1, 2)' has no value at the initial point, where it takes the root of a negative number: "
                  "choose another initial point");
    }
    const std::string twice = refusal("v' = -sign(v) + sign(w)/2; w' = -sign(w) - sign(v)/2; v(0) = 0; w(0) = 0", "1");
    CHECK(twice.find("sign(v)") == twice.rfind("sign(v)"));
    try {
        solve(problem(ode::with_column(ode::parse("x' = 1; x(0) = 0; E = 1/x"), "E")));
        CHECK(false);
    } catch (const error& none) {
        CHECK_THAT(none.what(),
                   Catch::Contains("'E' has no value at the initial point, where its equation divides by zero"));
    }
}

TEST_CASE("a condition that is an equality for some time holds as it is written", "[problem][hybrid]") {
    const precision_scope scope(60);
    check_values({
        {"y' = if(a >= 1, 2, 3); y(0) = 0; a = 1", "1", "y", 2},
        {"y' = if(a > 1, 2, 3); y(0) = 0; a = 1", "1", "y", 3},
        {"y' = if(a >= 0.1 + 0.2, 1, 3); y(0) = 0; a = 0.3", "1", "y", 1},
        {"y' = if(sqrt(2)^2 > 2, 1, 3); y(0) = 0", "1", "y", 3},
        {"y' = if(floor(t) >= 1, 1, 3); y(0) = 0", "3", "y", 5},
        {"y' = if(min(t, 1) < 1, 1, 3); y(0) = 0", "3", "y", 7},
        {"y' = if(sign(x) >= 1, 1, 3); x' = 1; x(0) = -1; y(0) = 0", "2", "y", 4},
        {"y' = if(max(x, y) - x > 0, 1, 3); x' = -1; y(0) = 0; x(0) = 1", "1/8", "y", mpfr(3) / 8},
        {"y' = if(if(t > 1, 1, 0) >= 1, 3, 5); y(0) = 0", "3", "y", 11},
        {"y' = 1 + sign(a - 2); y(0) = 0; a = 2", "1", "y", 1},
        {"y' = heaviside(a - 2); y(0) = 0; a = 2", "1", "y", mpfr(1) / 2},
    });
}

TEST_CASE("a solution that remains on a surface has the value of the relation there", "[problem][hybrid]") {
    const precision_scope scope(60);
    check_values({
        {"x' = abs(x - 2); x(0) = 2", "1", "x", 2},
        {"x' = if(x >= 2, x - 2, 2 - x); x(0) = 2", "1", "x", 2},
        {"x' = abs(x) + t; x(0) = 0", "1", "x", mpfr(exp(mpfr(1)) - 2)},
        {"x' = 1; z' = 1; y' = if(x > z, 1, 3); x(0) = 0; z(0) = 0; y(0) = 0", "1", "y", 3},
        {"x' = v; v' = -x; y' = if(x^2 + v^2 <= 1, 1, 0); x(0) = 1; v(0) = 0; y(0) = 0", "2", "y", 2},
    });
    // The order of the unknowns is that of the equations as typed, whatever a branch contains.
    check_values({
        {"x' = if(x > 0, z, 0)*x + abs(x); y' = z; z' = y; x(0) = 0; y(0) = 2; z(0) = 3", "1", "y",
         mpfr(2 * cosh(mpfr(1)) + 3 * sinh(mpfr(1)))},
        {"x' = if(x >= 0, 0*z + x*y, x*z); y' = 1; z' = 5; x(0) = 0; y(0) = 0; z(0) = 0", "1", "z", 5},
    });
    // Stated where the right-hand side is not continuous across the surface, and only there.
    const auto notes = [](const std::string& text) {
        return solve(problem(text))->states("1", proved_digits(10)).notes;
    };
    const auto jumping = notes("x' = 1; z' = 1; y' = if(x > z, 1, 3); x(0) = 0; z(0) = 0; y(0) = 0");
    REQUIRE(jumping.size() == 1);
    CHECK_THAT(jumping.front().text, Catch::Contains("`if(x > z, 1, 3)`"));
    CHECK(notes("x' = abs(x - 2); x(0) = 2").empty());
    // The jump is in the equation of another unknown, and depends on another open step.
    CHECK(notes("x' = -x; z' = 1; y' = sign(x)*(sign(z) + 1); x(0) = 0; y(0) = 0; z(0) = 0").size() == 1);
}

TEST_CASE("solutions that are not unique have no value", "[problem][hybrid]") {
    for (const std::string text :
         {"x' = if(y > 0, 1, -sign(x)); y' = sign(y); x(0) = 0; y(0) = 0",
          "x' = if(x > 0, y, z); y' = if(x > 0, 1, -5); z' = if(x > 0, -5, 1); x(0) = 0; y(0) = 0; z(0) = 0",
          "x' = sign(max(x, 0))^2 - 1/2; x(0) = 0", "x' = sign(x)^2; x(0) = 0", "x' = if(x > 2, 1, 0); x(0) = 2",
          "x' = sign(x); x(0) = 0; z' = 1; z(0) = 0; y' = if(z - 1 + sign(x) > 0, 1, 2); y(0) = 0",
          "x' = if(p > 0, sign(x), -1); p' = 0; x(0) = 1; p(0) = -1; when x = 0: p = 1"}) {
        INFO(text);
        CHECK_FALSE(refusal(text, "2").empty());
    }
    // Other solutions leave the surface later, where a step inside the other branch changes.
    for (const std::string text : {"x' = x + (1 + sign(t - 2 + sign(x)^2))*sign(x); x(0) = 0",
                                   "x' = x + if(t + sign(x)^2 > 2, sign(x), 0); x(0) = 0"}) {
        INFO(text);
        CHECK_FALSE(refusal(text, "3/2").empty());
    }
    // One choice remains although another argument depends on the sign.
    CHECK(refusal("x' = 1; x(0) = 0; z' = 1; z(0) = 0; y' = if(z - 1 + sign(x) > 0, 1, 2); y(0) = 0", "1").empty());
    CHECK(refusal("x' = -sign(x); x(0) = 1", "2").empty());
    CHECK_THAT(refusal("x' = if(x > 0, -1, if(x < 0, 1, 5)); x(0) = 1", "2"), Catch::Contains("slides"));
    CHECK_THAT(
        refusal("x'' = -1; x(0) = 1; x'(0) = 0; y' = sign(x)*z; z' = 1; y(0) = 0; z(0) = 0; when x = 0: x' = 0", "2"),
        !Catch::Contains("slides"));
}

TEST_CASE("a function that vanishes on a branch keeps its domain", "[problem][hybrid]") {
    CHECK_THAT(refusal("x' = abs(x)*log(1 - t); x(0) = 0", "2"), Catch::Contains("is not reached"));
    CHECK_THAT(refusal("y' = sign(a)*log(1 - t); y(0) = 0; a = 0", "2"), Catch::Contains("is not reached"));
    CHECK_THAT(refusal("y' = floor(t/9)*log(1 - t); y(0) = 0", "2"), Catch::Contains("is not reached"));
    // Factors of what is chosen, and arguments.
    for (const std::string text :
         {"y' = max(t - 3, 0)*log(1 - t); y(0) = 0", "y' = if(t > 3, 1, 0)*log(1 - t); y(0) = 0",
          "x' = max(x, 0)/(1 - t); x(0) = -1", "y' = if(sign(a)*log(1 - t) + 1 > 0, 1, 2); y(0) = 0; a = 0",
          "y' = floor(floor(t/5)*sqrt(1 - t) + 3/2); y(0) = 0",
          "y' = if(log(z) >= log(z), 1, 2); z' = -1; z(0) = 1; y(0) = 0",
          "y' = max(log(1 - t), log(1 - t)) - log(1 - t); y(0) = 0", "x' = if(x > 0, 2*x/(t - 1), 0); x(0) = 0"}) {
        INFO(text);
        CHECK_THAT(refusal(text, "2"), Catch::Contains("is not reached"));
        CHECK(refusal(text, "1/2").empty());
    }
    // Parts that cancel, in arguments and in conditions of events.
    for (const std::string text :
         {"x' = if(t + log(1 - t) > 1/4 + log(1 - t), 1, 0); x(0) = 1",
          "z' = -1; z(0) = 1; x' = if(x + sqrt(z) - sqrt(z) > 0, 1, 0); x(0) = 1",
          "x' = if(x + 1/z > 1/z, 1, 0); z' = -1; z(0) = 1; x(0) = 1",
          "x' = 1; x(0) = 0; when t + log(1 - t) - log(1 - t) = 3/4: x = 5",
          "z' = -1; z(0) = 1; x' = if(x > 0, 1, 2) + if(x + log(z) - log(z) > 0, 1, 0); x(0) = 1"}) {
        INFO(text);
        CHECK_THAT(refusal(text, "2"), Catch::Contains("is not reached"));
        CHECK(refusal(text, "1/2").empty());
    }
    CHECK(refusal("y' = if(t > 3, log(1 - t), 0); y(0) = 0", "2").empty());
    // Both ways round, by one step function.
    CHECK(refusal("y' = if(t > 3, 1, 0) + if(-t >= -3, 2, log(1 - t)); y(0) = 0", "2").empty());
    // What is not chosen need not be defined.
    CHECK(refusal("y' = if(a > 0, log(1 - t), 1); y(0) = 0; a = 0", "2").empty());
}

TEST_CASE("functions of time that are 0 at a common exact time are crossed together", "[problem][hybrid]") {
    const precision_scope scope(60);
    check_values({
        {"y' = if(sin(2*pi*t) > 0, t - floor(t), 0); y(0) = 0", "3", "y", mpfr(3) / 8},
        {"y' = if(sin(2*pi*t) > 0, 1, 0)*if(cos(pi*t) > 0, 1, 0); y(0) = 0", "5/2", "y", 1},
        {"y' = if(sin(t) > 0, 1, 0)*if(sin(2*t) > 0, 1, 0); y(0) = 0", "2*pi", "y", mpfr(libration::pi<mpfr>() / 2)},
    });
}

TEST_CASE("a known time is found once", "[problem][hybrid]") {
    const answer found = solve(problem("x' = sign(x); x(0) = 1"))->events("t = 1", 2, proved_digits(10));
    CHECK(found.rows.size() == 1);
    CHECK(refusal("x' = 1; x(0) = 0; when t = 1 down: x = 5", "2").empty());
}

TEST_CASE("piecewise functions in events, and of highest derivatives, are rejected", "[problem][hybrid]") {
    CHECK_THAT(refusal("x' = if(x' > 0, 1, 2); x(0) = 0", "2"), Catch::Contains("is not part of the state"));
    CHECK_THAT(refusal("x' = -1; r = abs(x); x(0) = 2; y' = r; y(0) = 0; when r = 1: y = 10", "3"),
               Catch::Contains("piecewise"));
}

TEST_CASE("times next to that of an event are compared exactly", "[problem][hybrid]") {
    const answer found =
        solve(problem("x' = 1; x(0) = 0; when t = 1 + 5e-61: x = x + 1"))->states("1 + 1e-60, 1", proved_digits(10));
    CHECK(found.at(0, "x") == "2.000000000");
    CHECK(found.at(1, "x") == "1.000000000");
}

TEST_CASE("a limit of one search ends the path before later events of others", "[problem][hybrid]") {
    const std::string text =
        "a' = 2*(t - 5); a(0) = 25; z' = 3*(t - 2)^2; z(0) = -8; y' = 0; y(0) = 0; w' = 0; w(0) = 0; "
        "when a = 0: w = 1; when z = 0: y = y + 1";
    const answer found = solve(problem(text))->states("3, 6", proved_digits(10));
    REQUIRE(found.missing);
    CHECK_THROWS_WITH(found.at(0, "y"), Catch::Contains("time '3' is not reached"));
}

TEST_CASE("a branch that is not regular at its beginning keeps the values before it", "[problem][hybrid]") {
    const answer found = solve(problem("y' = if(t > 1, 1/y, -1); y(0) = 1"))->states("1/2, 2", proved_digits(10));
    CHECK(found.at(0, "y") == "0.5000000000");
    CHECK_THROWS_WITH(found.at(1, "y"), Catch::Contains("after one event, at time 1.00000000000"));
}

}  // namespace problem_branches_test
