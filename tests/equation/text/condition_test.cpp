// Conditions that combine comparisons: their reading, their branches, and solutions by hand.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"

namespace ode_condition_test {

using namespace libration;
using namespace libration::ode;

namespace {

struct known_case {
    std::string condition;
    std::string rest;
    std::string time;
    mpfr value;
};

// The time for which a condition holds up to another one, to 20 proved digits.
void check_durations(const std::vector<known_case>& all) {
    for (const known_case& each : all) {
        INFO(each.condition << " up to " << each.time);
        const std::string text = "y' = if(" + each.condition + ", 1, 0); y(0) = 0" + each.rest;
        const answer found = solve(problem(text))->states(each.time, proved_digits(20));
        CHECK(abs(mpfr(mpfr(found.at(0, "y")) - each.value)) <= abs(each.value) * pow(mpfr(10), -19));
    }
}

// The value of a condition on x and y for signs of x and y, as a branch folds it.
rational holds_for(const std::string& condition, int x, int y) {
    const hybrid_system hybrid(parse("w' = if(x > 0, 0, 0) + if(y > 0, 0, 0) + if(" + condition +
                                     ", 1, 0); x' = 1; y' = 1; x(0) = 0; y(0) = 0; w(0) = 0"));
    REQUIRE(hybrid.steps().size() == 2);
    return *hybrid.first_branch({number(rational(x)), number(rational(y))}).right()[0].fraction();
}

void check_refused(const std::string& condition, const std::string& reason) {
    INFO(condition);
    CHECK_THROWS_WITH(parse("y' = if(" + condition + ", 1, 0); y(0) = 0"), Catch::Contains(reason));
}

}  // namespace

TEST_CASE("conditions have the values of Boolean algebra for all signs of their sides", "[ode][parse][hybrid]") {
    for (const int x : {-1, 0, 1}) {
        for (const int y : {-1, 0, 1}) {
            INFO(x << ", " << y);
            const auto check = [&](const std::string& condition, bool holds) {
                INFO(condition);
                CHECK(holds_for(condition, x, y) == (holds ? 1 : 0));
            };
            for (const std::string word : {"and", "&&", "&", "∧"}) {
                check("x > 0 " + word + " y >= 0", x > 0 && y >= 0);
            }
            for (const std::string word : {"or", "||", "|", "∨"}) {
                check("x < 0 " + word + " y <= 0", x < 0 || y <= 0);
            }
            check("and(x > 0, y >= 0)", x > 0 && y >= 0);
            check("or(x > 0, y >= 0, x < 0)", x > 0 || y >= 0 || x < 0);
            check("not(x > 0)", x <= 0);
            check("not x > 0", x <= 0);
            check("!(x > 0)", x <= 0);
            check("¬(x > 0)", x <= 0);
            check("not not (x > 0)", x > 0);
            check("x == 0", x == 0);
            check("x != 0", x != 0);
            check("x ≠ 0", x != 0);
            check("x == 0 and y != 0", x == 0 && y != 0);
            check("-x >= 0 and -y > 0", x <= 0 && y < 0);
            // `not` before `and` before `or`.
            check("x > 0 or y > 0 and x < 0", x > 0 || (y > 0 && x < 0));
            check("(x > 0 or y > 0) and x < 0", (x > 0 || y > 0) && x < 0);
            check("not x > 0 and y > 0", x <= 0 && y > 0);
            check("not (x > 0 and y > 0)", x <= 0 || y <= 0);
            check("((x) > (0)) and (((y > 0)))", x > 0 && y > 0);
            check("(x + 0)*2 > 0 or (2*y > 0)", x > 0 || y > 0);
            check("0 < x > 0", x > 0);
            check("x >= 0 == y", x >= 0 && y == 0);
            check("true and x > 0", x > 0);
            check("False or (x > 0)", x > 0);
        }
    }
}

TEST_CASE("solutions change branch where a combined condition does", "[ode][parse][hybrid][problem]") {
    const precision_scope scope(60);
    const mpfr pi = libration::pi<mpfr>();
    const std::string wave = "; x'' = -x; x(0) = 0; x'(0) = 1";
    check_durations({
        {"1 <= t < 2 and not (y > 10)", "", "17", 1},
        {"t >= 1 and t < 2", "", "5", 1},
        {"t < 1 or t > 3", "", "5", 3},
        {"3 > t >= 2", "", "5", 1},
        {"0 < t < 1 or 2 < t < 3 or 4 < t", "", "5", 3},
        {"not (1 < t < 2)", "", "5", 4},
        {"-1/2 < x < 1/2", wave, "6", mpfr(2 * pi / 3 - (2 * pi - 6))},
        {"x > 0 and x' < 0", wave, "8", mpfr(8 - 2 * pi)},
        {"x > 0 or x' > 0", wave, "7", mpfr(7 - pi / 2)},
        // Equality holds on an interval, or not at all; a moment counts for nothing.
        {"a == 2", "; a = 2", "3", 3},
        {"a != 2", "; a = 2", "3", 0},
        {"a == 2", "; a = 3", "3", 0},
        {"t == 1", "", "3", 0},
        {"t != 1", "", "3", 3},
        {"floor(t) == 1", "", "3", 1},
        {"floor(t) != 1", "", "7/2", mpfr(5) / 2},
        {"mod(floor(t), 2) == 0 and t < 7/2", "", "6", 2},
        {"x == z", "; x' = 1; z' = 1; x(0) = 0; z(0) = 0", "2", 2},
        {"max(t, 1) == 1", "", "3", 1},
        {"sqrt(2)^2 == 2 and t > 1", "", "3", 2},
    });
}

TEST_CASE("an event begins with a comparison, as where its sides cross", "[ode][parse][hybrid]") {
    const auto below = parse("y' = -y; y(0) = 4; when y < k: y = 5; k = 1").events.front();
    CHECK(below.way == crossing::up);
    CHECK(same_form(below.condition, parameter("k") + -unknown("y")));
    CHECK_FALSE(below.holds);
    CHECK(below.text == "when y < k");
    const auto refused = [](const std::string& condition, const std::string& reason) {
        INFO(condition);
        CHECK_THROWS_WITH(hybrid_system(parse("y' = -y; y(0) = 4; when " + condition + ": y = 5")),
                          Catch::Contains(reason));
    };
    refused("y < 1 up", "has a direction and a condition: write when x > 1, or when x = 1 up");
    CHECK(parse("y' = -y; y(0) = 4; when y == 1: y = 5").events.front().way == crossing::any);
    refused("true or y < 1", "has a condition that does not depend on the solution");
    refused("y > 1 and y", "'y' at line 1, column 35 is not a comparison");
}

// Saws of slope 1, and their values by hand.
TEST_CASE("an event with a combined condition happens where that begins to hold", "[ode][parse][hybrid][problem]") {
    const precision_scope scope(60);
    const auto check = [](const std::string& text, const std::string& time, const mpfr& value) {
        INFO(text << " at " << time);
        const answer found = solve(problem("y' = 1; y(0) = 0; " + text))->states(time, proved_digits(20));
        CHECK(abs(mpfr(mpfr(found.at(0, "y")) - value)) <= abs(value) * pow(mpfr(10), -19));
    };
    // At 5/2, where t passes it while y is above 1; then y passes 1 at 7/2 and 9/2.
    check("when y > 1 and t > 5/2: y = 0", "3", mpfr(1) / 2);
    check("when y > 1 and t > 5/2: y = 0", "5", mpfr(1) / 2);
    // y passes 1 at 1, 2 and 3, but from then on t is too large.
    check("when y > 1 and t < 7/2: y = 0", "5", 2);
    check("when y > 1 or t > 1/2: y = 0", "3", mpfr(5) / 2);
    check("when 1 < y < 2: y = 0", "5/2", mpfr(1) / 2);
    check("when not (y < 1): y = 0", "5/2", mpfr(1) / 2);
    // Held from the beginning: no event.
    check("when y < 1 and t > -1: y = 7", "3/2", mpfr(3) / 2);
    // A dose at the beginning of each third of the time, except the first.
    check("when mod(t, 3) < 1: y = y + 10", "8", 28);
    check("when mod(t, 3) < 1 and t < 4: y = y + 10", "8", 18);
    check("when x < 0 and x' < 0: y = 0; x'' = -x; x(0) = 0; x'(0) = 1", "7", mpfr(7 - libration::pi<mpfr>()));
    // Both events at one time, in the order of the statements.
    check("when y > 1 and t > 0: y = 5; when y = 1 up: y = 2*y", "3/2", mpfr(21) / 2);
    // A bounce as in other programs.
    const answer bounced = solve(problem("h'' = -2; h(0) = 1; h'(0) = 0; when h < 0 and h' < 0: h' = -h'/2"))
                               ->states("3/2", proved_digits(20));
    CHECK(mpfr(bounced.at(0, "h")) == mpfr(1) / 4);
    const answer ended = solve(problem("y' = 1; y(0) = 0; when y > 1 and t > 0: stop"))->states("2", proved_digits(20));
    REQUIRE(ended.missing);
    CHECK_THAT(std::string(ended.missing->what()), Catch::Contains("`when y > 1 and t > 0` ends the solution"));
}

TEST_CASE("conditions are refused with their operator and the remedy", "[ode][parse][hybrid]") {
    check_refused("y > 0 and", "is not a number or a name");
    check_refused("y > 0 and t", "'t' at line 1, column 19 is not a comparison: write if(x > 0, a, b)");
    check_refused("y = 0", "'=' at line 1, column 11 is not a comparison: write == in a condition");
    check_refused("(y > 0)*2 > 1", "'*' at line 1, column 16 follows a condition, which is not a number");
    check_refused("(y > 0) > 1", "'>' at line 1, column 17 follows a condition, which is not a number");
    check_refused("!y > 0", "is not followed by a parenthesis: write !(x > 1)");
    check_refused("and y > 0", "has no condition before it: write x > 1 and y > 1");
    check_refused("and(y > 0, t > 0", "'1' at line 1, column 27 is not a comparison");
    const auto refused = [](const std::string& text, const std::string& reason) {
        INFO(text);
        CHECK_THROWS_WITH(parse(text), Catch::Contains(reason));
    };
    refused("y' = y > 0; y(0) = 0", "'>' at line 1, column 8 is not expected here: write conditions in if(");
    refused("y' = |y|; y(0) = 0", "write abs(x) for |x|");
    refused("y' == y; y(0) = 0", "'==' at line 1, column 4 is not an equation: write =");
    std::string deep = "y > 0";
    for (int i = 0; i < 200; ++i) {
        deep = "(" + deep + ")";
    }
    refused("y' = if(" + deep + ", 1, 0); y(0) = 0", "is nested more than 100 deep");
}

TEST_CASE("the words of conditions are names where a problem defines them", "[ode][parse]") {
    CHECK(parse("and' = -and*or; and(0) = 1; or = 2").unknowns() == std::vector<std::string>{"and"});
    const std::string standard = canonical_text("y' = if(t > 1 && !(y > 1) || t≠2, 1, 2y); y(0) = 0");
    CHECK(standard == "y' = if(t>1 and not (y>1) or t != 2, 1, 2*y)\ny(0) = 0\n");
    CHECK(canonical_text(standard) == standard);
}

}  // namespace ode_condition_test
