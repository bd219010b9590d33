// Unknowns that resets alone change, and events at multiples: values by hand.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"
#include "problem/known_values.hpp"

namespace problem_kept_values_test {

using namespace libration;
using namespace libration::tests;

namespace {

// y rises by 1 in each unit of time, at the end of which the statement follows.
std::string counted(const std::string& rest) {
    return "y' = 1; y(0) = 0; m' = 0; m(0) = 0; z(0) = 0; when y > 1: y = 0; m = m + 1; " + rest;
}

}  // namespace

TEST_CASE("values that resets alone change are exact numbers in conditions", "[problem][hybrid][kept]") {
    const precision_scope scope(60);
    const std::string two = "y' = 1; y(0) = 0; m' = 0; m(0) = 0; when y > 1 and m < 2: y = 0; m = m + 1";
    const std::string third = "; z(0) = 0; q' = 0; q(0) = 1/3; when t = 1: q = q/2 + t/6; z' = if(q == 1/3, 1, 5)";
    check_values({
        {two, "5/2", "y", mpfr(1) / 2},
        {two, "5/2", "m", 2},
        {two, "4", "y", 2},
        {counted("z' = if(m == 1, 1, 0)"), "9/2", "z", 1},
        {counted("z' = if(m >= 2, 1, 0)"), "9/2", "z", mpfr(5) / 2},
        {counted("z' = if(m > 2, 1, 0)"), "9/2", "z", mpfr(3) / 2},
        {counted("z' = mod(m, 2)"), "9/2", "z", 2},
        {counted("z' = mod(m, 3)"), "9/2", "z", mpfr(7) / 2},
        {counted("z' = sign(m - 2) + floor(m/2)"), "9/2", "z", mpfr(5) / 2},
        {"y' = 1; y(0) = 0" + third, "2", "z", 2},
        // A level that resets move, from the exact value.
        {"x' = 1; x(0) = 0; m' = 0; m(0) = 1; when x > m: m = 2*m", "5", "m", 8},
        // Fractions of 2 n bits, and more; numbers that are not fractions.
        {"q' = 0; q(0) = 1/3; z' = if(q == 1, 5, 1); z(0) = 0; when mod(16*t, 1) == 1/2: q = (q^2 + 1)/2", "1", "z", 1},
        {"q' = 0; q(0) = pi; z' = if(q > pi, 5, 1); z(0) = 0; when t = 1: q = q*1", "2", "z", 2},
        // Not exact, and decided nevertheless.
        {"x' = 1; x(0) = 0; q' = 0; q(0) = 0; z' = if(q > 2, 1, 0); z(0) = 0; when t = 1: q = exp(x)", "3", "z", 2},
    });
}

TEST_CASE("a thermostat and its mode", "[problem][hybrid][kept]") {
    const precision_scope scope(60);
    const std::string text =
        "T' = -(T - 10)/5 + 6*h; h' = 0; T(0) = 15; h(0) = 1; when T > 22: h = 0; when T < 18: h = 1";
    // 40 - 25 exp(-t/5) up to 22, then 10 + 12 exp(-s/5) down to 18 and 40 - 22 exp(-s/5) up to 22.
    const mpfr first = 5 * log(mpfr(25) / 18);
    const mpfr down = 5 * log(mpfr(12) / 8);
    const mpfr up = 5 * log(mpfr(22) / 18);
    mpfr since = 20 - first;
    while (since > down + up) {
        since -= down + up;
    }
    REQUIRE(since < down);
    check_values({{text, "20", "T", mpfr(10 + 12 * exp(mpfr(-since / 5)))}, {text, "1", "h", 1}});
    const answer found = solve(problem(text))->states("20", proved_digits(15));
    CHECK(found.at(0, "h") == "0");
    CHECK_FALSE(found.missing);
}

TEST_CASE("a condition on such values begins to hold by a reset", "[problem][hybrid][kept]") {
    const precision_scope scope(60);
    const std::string modes = counted("z' = if(m == 1, 1, 0); when m >= 3: m = 0");
    const std::string stop = "y' = -1; y(0) = 1; m' = 0; m(0) = 0; when y < 0: y = 1; m = m + 1; when m >= 2: stop";
    check_values({
        {modes, "11/2", "z", 2},
        {modes, "11/2", "m", 2},
        {counted("z' = 0; when m = 2: z = z + 7"), "9/2", "z", 7},
        {counted("z' = 0; when m == 2 or m == 4: z = z + 7"), "9/2", "z", 14},
        // It jumps over 3, and 1 holds from the start.
        {"m' = 0; m(0) = 1; z' = 0; z(0) = 0; when t = 1: m = 5; when m == 3: z = 1; when m == 1: z = 2", "2", "z", 0},
        // One after the other at one time.
        {"m' = 0; m(0) = 0; z' = 1; z(0) = 0; when t = 1: m = 1; when m == 2: z = 10; when m == 1: m = 2", "2", "z",
         11},
        {stop, "3/2", "m", 1},
    });
    CHECK(refusal(stop, "3/2").empty());
    CHECK(refusal(stop, "5").find("`when m >= 2` ends the solution") != std::string::npos);
    CHECK(refusal("m' = 0; m(0) = 0; when t = 1: m = 1; when m == 1: m = 2; when m == 2: m = 1", "2")
              .find("make conditions hold again and again") != std::string::npos);
    CHECK(refusal("y' = 1; y(0) = 0; m' = 0; m(0) = 0; when y > 1: m = 1; when m = 1 up: stop", "2")
              .find("has a direction and a condition") != std::string::npos);
}

// 100 exp(-t/4) from each dose on.
TEST_CASE("events at the multiples of a number", "[problem][hybrid][kept]") {
    const precision_scope scope(60);
    const auto doses = [](const std::vector<rational>& times, const rational& at) {
        mpfr sum = 0;
        for (const rational& each : times) {
            const rational gone = at - each;
            sum += 100 * exp(mpfr(-mpfr(numerator(gone)) / denominator(gone) / 4));
        }
        return sum;
    };
    const auto dosed = [](const std::string& when) {
        return "A' = -A/4; A(0) = 100; tau = 8; when " + when + ": A = A + 100";
    };
    check_values({
        {dosed("mod(t, 8) == 0"), "20", "A", doses({0, 8, 16}, 20)},
        {dosed("mod(t, 8) = 0"), "20", "A", doses({0, 8, 16}, 20)},
        {dosed("mod(t, 8) = 0"), "16", "A", doses({0, 8, 16}, 16)},
        {dosed("mod(t, tau) == 3"), "20", "A", doses({0, 3, 11, 19}, 20)},
        {dosed("3 = mod(t, tau)"), "20", "A", doses({0, 3, 11, 19}, 20)},
        {dosed("mod(-t, 8) == 3"), "20", "A", doses({0, 5, 13}, 20)},
        {dosed("mod(2*t + 1, 3) == 2"), "4", "A", doses({0, rational(1, 2), 2, rational(7, 2)}, 4)},
        {dosed("t == 2"), "20", "A", doses({0, 2}, 20)},
        {dosed("t = 8 or t = 16"), "20", "A", doses({0, 8, 16}, 20)},
        {dosed("t == 8 or t == 16 or t > 18"), "20", "A", doses({0, 8, 16, 18}, 20)},
        // Both at 24, where one dose follows.
        {dosed("mod(t, 8) == 0 or mod(t, 12) == 0"), "25", "A", doses({0, 8, 12, 16, 24}, 25)},
        {dosed("t = 2 or t = 2"), "3", "A", doses({0, 2}, 3)},
        {dosed("mod(t, 8) < 1"), "20", "A", doses({0, 8, 16}, 20)},
    });
    CHECK(refusal(dosed("mod(t, 8) == 9"), "20").find("remainder that mod does not take") != std::string::npos);
    CHECK(refusal(dosed("mod(A, 8) == 0"), "20").find("as when mod(x, 8) < 1") != std::string::npos);
    CHECK(refusal(dosed("t == 8 and A > 1"), "20").find("joins a moment by `and`") != std::string::npos);
}

// The angles at which sine and cosine pass the levels.
TEST_CASE("step functions of one function of the time switch together", "[problem][hybrid][kept]") {
    const precision_scope scope(60);
    const mpfr pi = libration::pi<mpfr>();
    const mpfr three(3);
    const mpfr six(6);
    check_values({
        {"y' = round(2*sin(t)); y(0) = 0", "3", "y", mpfr(2 * pi - 2 * (asin(mpfr(1) / 4) + asin(mpfr(3) / 4)))},
        {"y' = trunc(3*cos(t)); y(0) = 0", "3", "y", mpfr(2 * pi - 6)},
        {"y' = fmod(5*cos(t), 2); y(0) = 0", "3", "y", mpfr(5 * sin(three) - 2 * (2 * pi - 6))},
        {"y' = fmod(t^2, 3); y(0) = 0", "5/2", "y", mpfr(mpfr(125) / 24 - 3 * (5 - sqrt(six) - sqrt(three)))},
    });
}

TEST_CASE("a derivative by a number that such a value depends on is not taken across its jump",
          "[problem][hybrid][kept]") {
    request how = proved_digits(10);
    how.derivatives = {"m(0)"};
    CHECK_THROWS_WITH(solve(problem("y' = if(m >= 2, 1, 0); y(0) = 0; m' = 0; m(0) = 2"))->states("1", how),
                      Catch::Contains("remains on the surface"));
}

}  // namespace problem_kept_values_test
