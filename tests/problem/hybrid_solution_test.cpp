// Solutions with events and piecewise right-hand sides, against closed forms computed here in mpfr.
#include "libration/problem/solution.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace problem_hybrid_solution_test {

using namespace libration;

namespace {

constexpr long digits = 30;

// Whether a proved decimal of 30 digits is within one unit of its last digit of the exact value, given with 80 digits.
bool agrees(const std::string& decimal, const mpfr& exact) {
    const mpfr printed(decimal);
    return abs(mpfr(printed - exact)) <= abs(exact) * pow(mpfr(10), -(digits - 1));
}

std::string value_at(const std::string& text, const std::string& time, const std::string& name) {
    return solve(problem(text))->states(time, proved_digits(digits)).at(0, name);
}

std::string missing_of(const std::string& text, const std::string& times) {
    const answer found = solve(problem(text))->states(times, proved_digits(digits));
    return found.missing ? found.missing->what() : "";
}

const std::string ball = "y'' = -9.81; y(0) = 10; y'(0) = 0; when y = 0 down: y' = -0.9*y'";

}  // namespace

TEST_CASE("the first 20 bounces of a ball are those of the closed form", "[problem][hybrid]") {
    const precision_scope scope(80);
    const mpfr g = mpfr(981) / 100;
    const mpfr restitution = mpfr(9) / 10;
    const auto y = solve(problem(ball));
    const answer bounces = y->events("y = 0", 20, proved_digits(digits));
    REQUIRE(bounces.rows.size() == 20);
    CHECK_FALSE(bounces.missing);
    mpfr time = sqrt(mpfr(20 / g));
    mpfr speed = g * time;
    for (std::size_t n = 0; n < 20; ++n) {
        INFO("bounce " << n + 1);
        CHECK(agrees(bounces.at(n, "time"), time));
        CHECK(bounces.at(n, "y") == "0");
        CHECK(agrees(bounces.at(n, "y'"), -speed));
        speed *= restitution;
        time += 2 * speed / g;
    }
    // Between bounces 1 and 2.
    const mpfr first = sqrt(mpfr(20 / g));
    const mpfr later = 2 - first;
    CHECK(agrees(y->states("2", proved_digits(digits)).at(0, "y"),
                 mpfr(restitution * g * first * later - g * later * later / 2)));
}

TEST_CASE("bounces that accumulate end the solution with one line", "[problem][hybrid]") {
    // The bounces accumulate at 19 sqrt(20/9.81) = 27.1...
    const answer found = solve(problem(ball))->states("27, 28", proved_digits(10));
    CHECK_FALSE(found.rows[0].empty());
    CHECK(found.rows[1].empty());
    REQUIRE(found.missing);
    CHECK_THAT(found.missing->what(), Catch::Contains("time '28' is not reached: after ") &&
                                          Catch::Contains("events, the last one proved at time 27.1") &&
                                          Catch::Contains("accumulate"));
}

TEST_CASE("resets at known times and by the state", "[problem][hybrid]") {
    const precision_scope scope(80);
    const std::string dose = "x' = -x; x(0) = 1; when t = 2: x = x + 1";
    CHECK(agrees(value_at(dose, "3", "x"), mpfr(exp(mpfr(-3)) + exp(mpfr(-1)))));
    CHECK(agrees(value_at(dose, "2", "x"), mpfr(exp(mpfr(-2)) + 1)));
    CHECK(agrees(value_at(dose, "1", "x"), exp(mpfr(-1))));
    // Integrate and fire: x = 2 - 2 exp(-t) up to 1, with the period log 2; and the number of spikes.
    const std::string neuron = "x' = 2 - x; n' = 0; x(0) = 0; n(0) = 0; when x = 1 up: x = 0; n = n + 1";
    const std::string renamed = "x' = 2 - x; k' = 0; x(0) = 0; k(0) = 0; when x = 1 up: x = 0; k = k + 1";
    CHECK(agrees(value_at(neuron, "5", "n_"), mpfr(7)));
    CHECK(agrees(value_at(renamed, "5", "x"), mpfr(2 - 2 * exp(mpfr(7 * log(mpfr(2)) - 5)))));
    CHECK(agrees(value_at(renamed, "5", "k"), mpfr(7)));
    // All resets are from the values before.
    const std::string swap = "x' = 0; y' = 0; x(0) = 1; y(0) = 2; when t = 1: x = y; y = x";
    CHECK(agrees(value_at(swap, "2", "x"), mpfr(2)));
    CHECK(agrees(value_at(swap, "2", "y"), mpfr(1)));
    // A projectile between walls at 0 and 1, in both directions.
    const std::string walls = "x'' = 0; x(0) = 1/3; x'(0) = 1; when x = 1: x' = -x'; when x = 0: x' = -x'";
    CHECK(agrees(value_at(walls, "5", "x"), mpfr(mpfr(2) / 3)));
    CHECK(agrees(value_at(walls, "5", "x'"), mpfr(-1)));
}

TEST_CASE("an event can end the solution", "[problem][hybrid]") {
    const std::string fall = "y'' = -2; y(0) = 1; y'(0) = 0; when y = 0 down: stop";
    const auto y = solve(problem(fall));
    const answer found = y->states("1/2, 3", proved_digits(20));
    CHECK(found.at(0, "y") == "0.75000000000000000000");
    REQUIRE(found.missing);
    CHECK_THAT(found.missing->what(),
               Catch::Contains("time '3' is not reached") &&
                   Catch::Contains("after one event, at time 1.00000000000, `when y = 0 down` ends the solution"));
    CHECK(y->events("y = 0", 1, proved_digits(20)).at(0, "y'") == "-2.0000000000000000000");
}

TEST_CASE("right-hand sides with sign, abs, if, max, min and heaviside", "[problem][hybrid]") {
    const precision_scope scope(80);
    // y'' = -sign(y): parabolas of half period 2 sqrt 2.
    const mpfr half = 2 * sqrt(mpfr(2));
    const mpfr from_top = 9 - 3 * half;  // y(9) = -(1 - s^2/2), s from the third extremum
    const std::string relay = "y'' = -sign(y); y(0) = 1; y'(0) = 0";
    CHECK(agrees(value_at(relay, "9", "y"), mpfr(-(1 - from_top * from_top / 2))));
    CHECK(agrees(value_at("y'' = if(y > 0, -1, 1); y(0) = 1; y'(0) = 0", "9", "y'"), from_top));
    // x' = abs(x - 1) - 1 from 0 decreases to 0: at once -x; up to 1 it does not reach.
    CHECK(agrees(value_at("x' = abs(x - 1); x(0) = 0", "3", "x"), mpfr(1 - exp(mpfr(-3)))));
    CHECK(agrees(value_at("x' = max(x, 2 - x); x(0) = 0", "2", "x"), mpfr(exp(mpfr(2 - log(mpfr(2)))))));
    CHECK(agrees(value_at("x' = 1 + min(x, 1); x(0) = 0", "2", "x"), mpfr(1 + 2 * (2 - log(mpfr(2))))));
    CHECK(agrees(value_at("x' = 1 + heaviside(x - 1); x(0) = 0", "3", "x"), mpfr(5)));
    CHECK(agrees(value_at("x' = if(t < 1, 1, -2*x); x(0) = 0", "2", "x"), exp(mpfr(-2))));
    // At the switching time itself, which is proved without being told.
    CHECK(agrees(value_at("x' = 1 + heaviside(x - 1); x(0) = 0", "1", "x"), mpfr(1)));
}

TEST_CASE("right-hand sides with floor, square and sawtooth waves of time", "[problem][hybrid]") {
    const precision_scope scope(80);
    const mpfr pi = libration::pi<mpfr>();
    CHECK(agrees(value_at("x' = floor(t); x(0) = 1", "7/2", "x"), mpfr(mpfr(11) / 2)));
    CHECK(agrees(value_at("x' = floor(1 - 2*t); x(0) = 1", "1", "x"), mpfr(mpfr(1) / 2)));
    CHECK(agrees(value_at("x' = square(t); x(0) = 1", "3*pi/2", "x"), mpfr(1 + pi / 2)));
    CHECK(agrees(value_at("x' = sawtooth(t); x(0) = 1", "3*pi", "x"), mpfr(1 - pi / 2)));
    CHECK(agrees(value_at("x' = square(2*pi*t); x(0) = 1", "21/4", "x"), mpfr(mpfr(5) / 4)));
}

TEST_CASE("the problems of the DETEST set with discontinuities have 20 digits at the end", "[problem][hybrid]") {
    const precision_scope scope(80);
    const mpfr pi = libration::pi<mpfr>();
    // F1: about +-c, c = 1/(pi^2 + a^2), the distance changes its sign and grows by e^a in each unit of time.
    mpfr y = 0;
    for (int n = 0; n < 20; ++n) {
        const mpfr centre = (n % 2 == 0 ? 1 : -1) / mpfr(pi * pi + mpfr(1) / 100);
        y = centre - (y - centre) * exp(mpfr(mpfr(1) / 10));
    }
    CHECK(agrees(value_at("detest_f1", "20", "y"), y));
    // F2: towards 55/r with the rates r = 3/2 and 1/2 in turn.
    y = 110;
    for (int n = 0; n < 20; ++n) {
        const mpfr rate = mpfr(n % 2 == 0 ? 3 : 1) / 2;
        y = 55 / rate + (y - 55 / rate) * exp(mpfr(-rate));
    }
    CHECK(agrees(value_at("detest_f2", "20", "y"), y));
    // F3, by smooth problems over each unit of time, integrated in mpfr.
    std::string start = "y(0) = 0; y'(0) = 0";
    for (int n = 0; n < 20; ++n) {
        const std::string force = n % 2 == 0 ? " - sin(pi*t)" : " + sin(pi*t)";
        const auto smooth = solve(problem("y'' = 0.01*y'*(1 - y^2) - y" + force + "; " + start));
        const std::string end = std::to_string(n + 1);
        const answer found = smooth->states(end, rounded_digits(60));
        start = "y(" + end + ") = " + found.at(0, "y") + "; y'(" + end + ") = " + found.at(0, "y'");
        y = mpfr(found.at(0, "y"));
    }
    CHECK(agrees(value_at("detest_f3", "20", "y"), y));
    CHECK(agrees(value_at("detest_f4", "20", "y"), mpfr(exp(mpfr(-20)) / 21)));
    // F5, (t - n)^(4/3) at 20 from n = 1 to 19 sums up to n^(4/3).
    CHECK(agrees(value_at("detest_f5", "20", "y"), mpfr(1)));
    // The slope of F1 is 0 at integers, which no precision proves.
    CHECK_THAT(missing_of("detest_f1", "1"), Catch::Contains("do not distinguish from 0"));
}

// u = tan(t - 1) is 0 at the first bounce, at t = 1, and tan 1 at the second.
TEST_CASE("a number of a bounce that is exactly 0 does not lose the others", "[problem][hybrid]") {
    const auto falling =
        solve(problem("y'' = -2; u' = 1 + u^2; y(0) = 1; y'(0) = 0; u(0) = -tan(1); when y = 0 down: y' = -y'/2"));
    const answer bounces = falling->events("y = 0", 2, proved_digits(20));
    REQUIRE(bounces.rows.size() == 2);
    CHECK(bounces.at(0, "time") == "1.0000000000000000000");
    CHECK(bounces.at(0, "y'") == "-2.0000000000000000000");
    CHECK(bounces.rows[0][3].text.empty());
    CHECK(mpfr(bounces.rows[0][3].bound) < mpfr("1e-60"));
    CHECK_THROWS_WITH(bounces.at(0, "u"), Catch::Contains("event '1' has a value of u that "));
    CHECK(bounces.at(1, "time") == "2.0000000000000000000");
    CHECK(bounces.at(1, "u") == "1.5574077246549022305");
}

// x = sin t crosses 1/6, 1/5, 1/4, 1/3, 1/2 upwards at their arc sines, several of them within one step, and downwards
// without an event.
TEST_CASE("surfaces that are crossed in one step are crossed in the order of their times", "[problem][hybrid]") {
    const std::vector<std::string> upwards{"1/6", "1/5", "1/4", "1/3", "1/2"};
    for (const bool reversed : {false, true}) {
        std::string text = "x'' = -x; x(0) = 0; x'(0) = 1; p' = 0; p(0) = 0";
        for (std::size_t k = 0; k < upwards.size(); ++k) {
            text += "; when x = " + upwards[reversed ? upwards.size() - 1 - k : k] + " up: p = p + 1";
        }
        INFO(text);
        const auto counts =
            solve(problem(text))->states("0.1, 0.19, 0.22, 0.3, 0.4, 1, 6, 6.48", proved_digits(digits));
        REQUIRE_FALSE(counts.missing);
        const std::vector<int> expected{0, 1, 2, 3, 4, 5, 5, 6};
        for (std::size_t i = 0; i < expected.size(); ++i) {
            CHECK(mpfr(counts.at(i, "p")) == expected[i]);
        }
    }
}

TEST_CASE("tangential solutions end with the surface and the time", "[problem][hybrid]") {
    const std::string touching = "y' = 2*(t - 1); x' = sign(y); y(0) = 1; x(0) = 0";
    CHECK_THAT(missing_of(touching, "2"), Catch::Contains("`sign(y)` is not decided") && Catch::Contains("touches"));
    CHECK_THROWS_WITH(solve(problem("x' = sign(x); x(0) = 0")), Catch::Contains("more than one"));
    CHECK_THAT(missing_of("y' = 1; y(0) = 0; when (t - 1)^2 = 0: y = y + 5", "3"),
               Catch::Contains("which is not an event"));
}

// Closed forms: a store that is empty, a motion at rest, growth that is limited.
TEST_CASE("solutions slide along a surface to which both sides lead", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    CHECK(mpfr(value_at("s' = v; v' = -2*if(v > 0, 1, 0); s(0) = 0; v(0) = 3", "5", "s")) == mpfr(9) / 4);
    CHECK(mpfr(value_at("B' = -k*if(B > 0, 1, 0); B(0) = 3; k = 1/2", "10", "B")) == 0);
    CHECK(mpfr(value_at("v' = -sign(v); v(0) = 1", "2", "v")) == 0);
    CHECK(mpfr(value_at("v' = -sign(v); v(0) = 0", "2", "v")) == 0);
    CHECK(mpfr(value_at("y' = if(y < 2, 1, 0); y(0) = 0", "5", "y")) == 2);
    const std::string stores = "P' = -if(P > 0, 4, 0); Q' = if(P > 0, 4, 0) - Q; P(0) = 2; Q(0) = 0";
    const mpfr half = exp(mpfr(-1) / 2);
    CHECK(agrees(value_at(stores, "1", "Q"), mpfr(4 * (1 - half) * half)));
    // What flows into the empty store flows out: Q' = 1 - Q from t = 2 on, when 2 + t - 2 t is 0.
    const std::string inflow = "P' = 1 - 2*if(P > 0, 1, 0); Q' = 2*if(P > 0, 1, 0) - Q; P(0) = 2; Q(0) = 0";
    const mpfr at_two = 2 * (1 - exp(mpfr(-2)));
    CHECK(agrees(value_at(inflow, "3", "Q"), mpfr(1 + (at_two - 1) * exp(mpfr(-1)))));
}

// Torricelli's law h' = -sqrt(h), (1 - t/2)^2 up to t = 2, and h' = -2 h^(1/3), (1 - 4t/3)^(3/2) up to 3/4; what flows out is
// collected, or decays: exp(-3) times the integral of (1 - s/2) exp(s) from 0 to 2.
TEST_CASE("stores become empty where their outflow is not differentiable", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const std::string tank = "h' = -if(h > 0, sqrt(h), 0); h(0) = 1";
    CHECK(mpfr(value_at(tank, "1", "h")) == mpfr(1) / 4);
    CHECK(value_at(tank, "3", "h") == "0");
    CHECK(value_at("h' = -2*if(h > 0, h^(1/3), 0); h(0) = 1", "1", "h") == "0");
    CHECK(value_at("h' = -sqrt(max(h, 0))*exp(h); h(0) = 1", "3", "h") == "0");
    CHECK(agrees(value_at(tank + "; Q' = if(h > 0, sqrt(h), 0); Q(0) = 0", "3", "Q"), mpfr(1)));
    CHECK(agrees(value_at(tank + "; Q' = if(h > 0, sqrt(h), 0) - Q; Q(0) = 0", "3", "Q"),
                 mpfr(exp(mpfr(-3)) * (exp(mpfr(2)) - 3) / 2)));
    // A store that fills again, one that does not empty, another law below 0, and a jump of another unknown.
    for (const std::string text :
         {"h' = -if(h > 0, sqrt(h)*cos(t), 0); h(0) = 1/100", "h' = -if(h > 0, sqrt(h), -1); h(0) = 1",
          "h' = -if(h > 0, sqrt(h), h); h(0) = 1; y' = if(h > 0, 1, 2); y(0) = 0",
          "h' = -if(h > 0, sqrt(h), 0); h(0) = 1; y' = if(h > 0, 1, 2); y(0) = 0"}) {
        INFO(text);
        CHECK_THAT(missing_of(text, "5"), Catch::Contains("is not reached"));
    }
}

// sqrt(h) falls by the integral of the factor over 2; the cascade by mpmath: w' = ((1 - t/2)/w - 1)/2 up to 2 for w = sqrt(b),
// then by 1/2, from w(2) = 0.81..
TEST_CASE("stores become empty one after another, and after a reset", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const std::string two =
        "a' = -if(a > 0, sqrt(a), 0); b' = -if(b > 0, sqrt(b), 0)*exp(-t/5); Q' = if(b > 0, sqrt(b), 0)*exp(-t/5); "
        "a(0) = 1; b(0) = 1; Q(0) = 0";
    const mpfr left = 1 - mpfr(5) / 2 * (1 - exp(mpfr(-49) / 100));
    CHECK(agrees(value_at(two, "49/20", "b"), mpfr(left * left)));
    CHECK(value_at(two, "4", "b") == "0");
    CHECK(agrees(value_at(two, "4", "Q"), mpfr(1)));
    const answer empty = solve(problem(two))->events("b = 0", 1, proved_digits(digits));
    CHECK(agrees(empty.at(0, "time"), mpfr(5 * log(mpfr(5) / 3))));
    const std::string cascade =
        "a' = -if(a > 0, sqrt(a), 0); b' = if(a > 0, sqrt(a), 0) - if(b > 0, sqrt(b), 0); a(0) = 1; b(0) = 2";
    CHECK(agrees(value_at(cascade, "3", "b"), mpfr("0.09783606219403981688464678731660622582456")));
    CHECK(value_at(cascade, "4", "b") == "0");
    CHECK(agrees(solve(problem(cascade))->events("b = 0", 1, proved_digits(digits)).at(0, "time"),
                 mpfr("3.625575134397267477850842533894941578708")));
    // Filled by a store that was empty: not followed, rather than 0.
    CHECK_THAT(missing_of(cascade + "; when t = 5: a = 1", "6"), Catch::Contains("is not reached"));
    // Rain up to t = 2: with c = S^(1/3), 3 c' = 1/c^2 - 1, then -1, and it is empty at 2 + 3 c(2), by mpmath.
    const std::string rain = "S' = if(t < 2, 1, 0) - if(S > 0, S^(2/3), 0); S(0) = 1/10";
    CHECK(value_at(rain, "8", "S") == "0");
    CHECK(agrees(solve(problem(rain))->events("S = 0", 1, proved_digits(digits)).at(0, "time"),
                 mpfr("4.7787660687137390477909046120270837211")));
    CHECK(value_at("S' = if(t < 2 or t > 6, 1, 0) - if(S > 0, S^(2/3), 0); S(0) = 1/10", "5", "S") == "0");
    CHECK_THAT(missing_of("S' = if(t < 2 or t > 6, 1, 0) - if(S > 0, S^(2/3), 0); S(0) = 1/10", "8"),
               Catch::Contains("is not reached"));
    const std::string filled = "h' = -if(h > 0, sqrt(h), 0); h(0) = 1; when t = 3: h = 2";
    const mpfr root = sqrt(mpfr(2)) - mpfr(1) / 2;
    CHECK(agrees(value_at(filled, "4", "h"), mpfr(root * root)));
    CHECK(value_at(filled, "7", "h") == "0");
    // An event between the last time before which others are searched for, and the time at which the store would be empty.
    const mpfr reset = sqrt(mpfr(mpfr(1) / 1600 + 1)) - mpfr(21) / 40;
    CHECK(
        agrees(value_at("h' = -if(h > 0, sqrt(h), 0); y' = 1; h(0) = 1; y(0) = 0; when y = 39/20: h = h + 1", "3", "h"),
               mpfr(reset * reset)));
}

// With h = v^3 and dt = v ds for the root of order 3; what flows out is 1. At the time itself both sides are bounds.
TEST_CASE("the laws by which stores become empty", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const auto collected = [](const std::string& flow) {
        return value_at("h' = -" + flow + "; Q' = " + flow + "; h(0) = 1; Q(0) = 0", "4", "Q");
    };
    for (const std::string flow : {"if(h <= 0, 0, sqrt(h))", "if(h > 0, cbrt(h), 0)", "if(h > 0, h^(1/3), 0)",
                                   "if(h > 0, sqrt(h)*(exp(h) - 1)/h, 0)", "if(h > 0, sqrt(h), 0)*(2 + sin(t))",
                                   "if(h > 0, h^(2/3), 0)*(3 + t^2)"}) {
        INFO(flow);
        CHECK(agrees(collected(flow), mpfr(1)));
    }
    const std::string third = "h' = -if(h > 0, cbrt(h), 0); h(0) = 1";
    CHECK(agrees(value_at(third, "149/100", "h"), mpfr(mpfr(1) / 150 * sqrt(mpfr(1) / 150))));
    CHECK(agrees(solve(problem(third))->events("h = 0", 1, proved_digits(digits)).at(0, "time"), mpfr(3) / 2));
    const answer at_time =
        solve(problem("h' = -if(h > 0, sqrt(h), 0); h(0) = 2"))->states("2*sqrt(2)", proved_digits(20));
    REQUIRE(at_time.missing);
    CHECK_THAT(at_time.missing->what(), Catch::Contains("is not distinguished from the time of an event"));
    CHECK_THAT(missing_of("h' = -if(h > 0, sqrt(h), 0)*(1 + 2*sin(t)); h(0) = 4", "6"),
               Catch::Contains("the two sides of `if(h > 0, sqrt(h), 0)` differ by at most"));
    const auto quotient =
        solve(problem(ode::with_column(ode::parse("h' = -if(h > 0, sqrt(h), 0); h(0) = 1; r = 1/h"), "r")))
            ->states("1,3", proved_digits(digits));
    CHECK(agrees(quotient.at(0, "r"), mpfr(4)));
    REQUIRE(quotient.missing);
    CHECK_THAT(quotient.missing->what(), Catch::Contains("has no value of r, which divides by zero at h = 0"));
}

// A block at rest under the force t against friction of at most 1 and at least -1 moves from t = 1 on; one under
// -cos(t) 2 rests from the time at which it stops until the force exceeds 1.
TEST_CASE("solutions leave the surface where one side leads away", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const std::string block = "x' = v; v' = t - sign(v); x(0) = 0; v(0) = 0";
    CHECK(mpfr(value_at(block, "1/2", "v")) == 0);
    CHECK(agrees(value_at(block, "3", "v"), mpfr(2)));
    CHECK(agrees(value_at(block, "3", "x"), mpfr(4) / 3));
    const std::string backwards = "x' = v; v' = -t - sign(v); x(0) = 0; v(0) = 0";
    CHECK(agrees(value_at(backwards, "3", "x"), mpfr(-4) / 3));
    // v = 1 - t + t^2/2 - t, with the zero 2 - sqrt(2) where the force t - 1 is within friction: at rest up to t = 2.
    const std::string stops = "v' = t - 1 - sign(v); v(0) = 1";
    CHECK(mpfr(value_at(stops, "1", "v")) == 0);
    CHECK(mpfr(value_at(stops, "19/10", "v")) == 0);
    CHECK(agrees(value_at(stops, "4", "v"), mpfr(2)));
    // The force is an unknown.
    CHECK(agrees(value_at("v' = w - sign(v); w' = 1; v(0) = 0; w(0) = 0", "3", "v"), mpfr(2)));
}

// Each of the two is the closed form of its own equation; a cascade keeps its mass: what flowed in and was stored flowed out.
TEST_CASE("solutions slide along several surfaces of which each decides separate terms", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const std::string stores = "A' = -if(A > 0, 1, 0); B' = -if(B > 0, 1, 0); A(0) = 1; B(0) = 2";
    CHECK(mpfr(value_at(stores, "3/2", "B")) == mpfr(1) / 2);
    CHECK(mpfr(value_at(stores, "3", "A")) == 0);
    CHECK(mpfr(value_at(stores, "3", "B")) == 0);
    CHECK(mpfr(value_at("x' = -sign(x); y' = -sign(y); x(0) = 1; y(0) = 2", "3", "y")) == 0);
    const std::string four =
        "A' = -if(A>0,1,0); B' = -if(B>0,1,0); C' = -if(C>0,1,0); D' = -if(D>0,1,0); A(0)=1; B(0)=2; C(0)=3; D(0)=4";
    CHECK(mpfr(value_at(four, "5", "D")) == 0);
    const std::string cascade =
        "A' = 1/2 - if(A > 0, 1, 0); B' = if(A > 0, 1, 0) - if(B > 0, 2, 0); C' = if(B > 0, 2, 0); A(0) = 1; B(0) = 1; "
        "C(0) = 0";
    CHECK(mpfr(value_at(cascade, "4", "B")) == 0);
    CHECK(agrees(value_at(cascade, "4", "C"), mpfr(4)));
    // What left both, 3 and 4, weighted.
    CHECK(agrees(value_at("E' = if(A > 0, 1, 0) + 5*if(B > 0, 2, 0); E(0) = 0; " + cascade, "4", "E"), mpfr(23)));
    // The mean of sign(y) is 1/4 from t = 2 on, when x = 2.
    const std::string friction = "x' = t - sign(x) + sign(y)/2; y' = 1/2 - 2*sign(y); x(0) = 1; y(0) = 3";
    CHECK(agrees(value_at(friction, "4", "x"), mpfr(25) / 4));
    // Both are refilled at t = 5, by 2 - 1 and 1 - 1/2.
    const std::string refilled =
        "A' = if(t < 5, 0, 2) - if(A > 0, 1, 0); B' = if(A > 0, 1, 0) - if(B > 0, 1/2, 0); A(0) = 1; B(0) = 1/10";
    CHECK(agrees(value_at(refilled, "7", "A"), mpfr(2)));
    CHECK(agrees(value_at(refilled, "7", "B"), mpfr(1)));
}

// The inflow is 0 at 2 pi and positive after it; the store fills from 2 pi + pi/6 on.
TEST_CASE("a store that is empty remains empty where its inflow begins at 0", "[problem][hybrid][sliding]") {
    const precision_scope scope(80);
    const std::string store = "B' = max(0, sin(t)) - if(B > 0, 1/2, 0); B(0) = 1/4";
    const mpfr pi = acos(mpfr(-1));
    CHECK(mpfr(value_at(store, "13/2", "B")) == 0);
    CHECK(agrees(value_at(store, "8", "B"), mpfr(sqrt(mpfr(3)) / 2 - cos(mpfr(8)) - (8 - 13 * pi / 6) / 2)));
}

// One remains on the surface, another one leaves it: B = (t - 3)^2/2 and B = 0, x = 2 + t and x = 2.
TEST_CASE("solutions that may remain on a surface or leave it end with this reason", "[problem][hybrid][sliding]") {
    CHECK_THAT(missing_of("B' = if(B > 0, t - 3, 0); B(0) = 2", "4"),
               Catch::Contains("time 3.0000") && Catch::Contains("can continue on more than one branch"));
    CHECK_THROWS_WITH(solve(problem("x' = if(x > 2, 1, 0); x(0) = 2")),
                      Catch::Contains("can continue on more than one branch"));
    CHECK_THROWS_WITH(solve(problem("x' = if(x < 2, -1, 0); x(0) = 2")),
                      Catch::Contains("can continue on more than one branch"));
}

TEST_CASE("a condition of equal numbers that no precision tells apart is named", "[problem][hybrid]") {
    CHECK_THROWS_WITH(solve(problem("y' = if(exp(log(3)) == 3, 1, 2); y(0) = 1")),
                      Catch::Contains("'if(exp(log(3)) == 3, 1, 2)' at line 1, column 6 has a number that may be 0") &&
                          Catch::Contains("write it in another form"));
    CHECK_THROWS_WITH(solve(problem("y' = if(sin(t)^2 + cos(t)^2 == 1, 1, 2); y(0) = 1")),
                      Catch::EndsWith("choose another initial point, or write the condition in another form"));
}

// The value on the surface is on neither side, two surfaces are open, or another condition contains the sign.
TEST_CASE("sliding that is not proved to be the only solution ends", "[problem][hybrid][sliding]") {
    CHECK_THAT(missing_of("v' = if(v > 0, -1, if(v < 0, 1, 5)); v(0) = 1", "2"), Catch::Contains("is not reached"));
    CHECK_THROWS_WITH(solve(problem("v' = -sign(v) + sign(w)/2; w' = -sign(w) - sign(v)/2; v(0) = 0; w(0) = 0")),
                      Catch::Contains("begins on a switching surface"));
    CHECK_THROWS_WITH(
        solve(problem("v' = -sign(v); y' = if(sign(v) + x > 1/2, 1, 0); x' = 0; v(0) = 0; x(0) = 0; y(0) = 0")),
        Catch::Contains("slides"));
    CHECK_THAT(missing_of("x' = -sign(x)*(2 + sign(y)); y' = -sign(y); x(0) = 1; y(0) = 2", "3"),
               Catch::Contains("other conditions change there, too"));
    CHECK_THAT(missing_of("h' = if(t < 5, 0, 1/10) - if(h > 0, sqrt(h), 0); h(0) = 1", "7"),
               Catch::Contains("time 5.0000") && Catch::Contains("not proved to be continuous"));
}

TEST_CASE("solutions in double follow the same branches", "[problem][hybrid]") {
    const auto y = solve(problem(ball));
    const request in_double{.scalar = {scalar_kind::binary64, 17}, .digits = 12};
    const answer rough = y->states("1, 10, 20", in_double);
    const answer proved = y->states("1, 10, 20", proved_digits(12));
    CHECK(rough.rigour == "heuristic");
    CHECK(proved.rigour == "proved");
    for (std::size_t i = 0; i < 3; ++i) {
        // Values up to 10, each with some roundings to 2^-53.
        CHECK(std::stod(rough.at(i, "y")) == Approx(std::stod(proved.at(i, "y"))).epsilon(1e-11));
    }
}

// The motion repeats at each whole time, and 2 is never reached.
TEST_CASE("a search without an end counts its steps across the events of the problem", "[problem][hybrid]") {
    const auto saw = solve(problem("x' = 1; x(0) = 0; when x = 1: x = 0"));
    const ode::event_request never{.g = saw->condition("x = 2"), .horizon = 30};
    const answer found = saw->events(never, proved_digits(digits), {});
    CHECK(found.rows.empty());
    REQUIRE(found.missing);
    CHECK_THAT(found.missing->what(), Catch::Contains("is not found within 30 steps after "));
    const ode::event_request often{.g = saw->condition("x = 1/2"), .count = 40, .horizon = 30};
    CHECK(saw->events(often, proved_digits(digits), {}).rows.size() == 40);
}

// x = e^-3t up to 1, then more by 1: r = 3 x + floor(t).
TEST_CASE("expressions of a solution with events have columns", "[problem][hybrid]") {
    const precision_scope scope(60);
    const auto shown = [](const std::string& text, const std::string& name) {
        return solve(problem(ode::with_column(ode::parse(text), name)));
    };
    const std::string text = "x' = -k*x; k = 3; x(0) = 1; r = k*x + floor(t); when t = 1: x = x + 1";
    const answer found = shown(text, "r")->states("1/2,2", proved_digits(digits));
    CHECK(agrees(found.at(0, "r"), mpfr(3 * exp(mpfr(-3) / 2))));
    CHECK(agrees(found.at(1, "r"), mpfr(3 * (exp(mpfr(-6)) + exp(mpfr(-3))) + 2)));
    // Before the event at its time, in double, and as a series of the first branch.
    const answer halved = shown(text, "r")->events("x = 1/2", 1, proved_digits(digits));
    CHECK(agrees(halved.at(0, "r"), mpfr(3) / 2));
    const request rounded{.scalar = {scalar_kind::binary64, 17}, .digits = 17};
    CHECK(abs(mpfr(mpfr(shown(text, "r")->states("2", rounded).at(0, "r")) - mpfr(found.at(1, "r")))) <
          pow(mpfr(10), -14));
    CHECK_THROWS_WITH(shown("x' = abs(x); x(0) = 1; k = 2", "k"), Catch::Contains("is not a name for an expression"));
}

TEST_CASE("what needs one smooth equation speaks of the first branch, or says so", "[problem][hybrid]") {
    const auto x = solve(problem("x' = if(x > 2, 0, 1 + x^2); x(0) = 0"));
    const answer radius = x->radius("", proved_digits(10));
    CHECK(radius.at(0, "lower").starts_with("1.57079632"));
    REQUIRE_FALSE(radius.notes.empty());
    CHECK_THAT(radius.notes.front().text, Catch::Contains("of the equations as they are at the initial point"));
    CHECK(x->series(3, "", proved_digits(10)).at(3, "x") == "0.3333333333");
    CHECK_THROWS_WITH(x->series(3, "1", proved_digits(10)), Catch::Contains("not supported for a problem with events"));
    CHECK_THROWS_WITH(x->limits(proved_digits(10)), Catch::Contains("not supported for a problem with events"));
    CHECK_THROWS_WITH(x->states("-1", proved_digits(10)), Catch::Contains("forwards only"));
}

}  // namespace problem_hybrid_solution_test
