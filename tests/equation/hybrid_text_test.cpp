// Events and piecewise functions in the text of a problem.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/equation/unused_parameters.hpp"

namespace ode_hybrid_text_test {

using namespace libration;
using namespace libration::ode;

namespace {

void check_refused(const std::string& text, const std::string& reason) {
    INFO(text);
    CHECK_THROWS_WITH(hybrid_system(parse(text)), Catch::Contains(reason));
}

}  // namespace

TEST_CASE("events are read with their directions, resets and ends", "[ode][parse][hybrid]") {
    const auto system = parse(
        "y'' = -g; x' = 0; y(0) = h; y'(0) = 0; x(0) = 1\n"
        "when y = 0 down: y' = -k*y'; x = x + 1\n"
        "k = 0.9; g = 9.81; h = 1\n"
        "when t = 2: x = 0, stop; when y = x up: y' = 0");
    REQUIRE(system.events.size() == 3);
    CHECK(system.events[0].way == crossing::down);
    REQUIRE(system.events[0].resets.size() == 2);
    CHECK(same_form(system.events[0].resets[0].of, unknown("y", 1)));
    CHECK(same_form(system.events[0].resets[0].value, -parameter("k") * unknown("y", 1)));
    CHECK(system.events[0].text == "when y = 0 down");
    CHECK(system.events[1].way == crossing::any);
    CHECK(system.events[1].stop);
    CHECK(same_form(system.events[1].condition, variable() - 2));
    CHECK(system.events[2].way == crossing::up);
    CHECK(system.parameters.size() == 3);
    CHECK(system.equations.size() == 2);
    CHECK(unused_parameters("y' = -1; y(0) = 1; k = 2; when y = 0: y = k").empty());
    CHECK(parse("y' = -1; y(0) = 1; when y = 0: y = k").open.size() == 1);
}

TEST_CASE("piecewise functions are formulas of step functions, equal ones once", "[ode][parse][hybrid]") {
    const auto system = parse("x' = abs(x - 1) + max(x, 1) - if(1 > x, 2, 3); x(0) = 0");
    REQUIRE(system.steps.size() == 1);
    CHECK(same_form(system.steps[0].argument, unknown("x") - 1));
    const hybrid_system hybrid(system);
    const auto above = hybrid.first_branch({number(rational(1))});
    CHECK(same_form(above.right()[0], unknown("x") - 1 + unknown("x") - 3));
    const auto below = hybrid.first_branch({number(rational(-1))});
    CHECK(same_form(below.right()[0], -1 * (unknown("x") - 1) + 1 - 2));
    CHECK_FALSE(system.is_smooth());
    CHECK_THROWS_WITH(
        explicit_system(system),
        "problem 'abs(x - 1)' at line 1, column 6 is piecewise, which only reference, trajectory and verify "
        "support, without a certificate: leave it out");
    CHECK_THROWS_WITH(
        explicit_system(parse("y' = -1; y(0) = 1; when y = 0: y = 1")),
        "problem 'when y = 0' at line 1, column 20 is an event, which only reference, trajectory and verify "
        "support, without a certificate: leave it out");
}

TEST_CASE("the standard notation of events and piecewise functions is read as the same system",
          "[ode][parse][hybrid]") {
    const std::string text =
        "y'' = -sign(y) + if(y <= 1, 2 y, 0); y(0) = 1; y'(0) = 0; when 2y = 0 down: y' = -2y', stop";
    const std::string standard = canonical_text(text);
    CHECK(standard == "y'' = -sign(y) + if(y<=1, 2*y, 0)\ny(0) = 1\ny'(0) = 0\nwhen 2*y = 0 down: y' = -2*y'\nstop\n");
    CHECK(canonical_text(standard) == standard);
    const auto system = parse(standard);
    CHECK(system.events.size() == 1);
    CHECK(system.events[0].stop);
}

TEST_CASE("conditions keep whether they hold where both sides are equal", "[ode][parse][hybrid]") {
    const auto value_for = [](const std::string& condition, int sign) {
        const hybrid_system hybrid(parse("y' = if(" + condition + ", 1, 0); x' = 1; x(0) = 0; y(0) = 0"));
        return hybrid.first_branch({number(rational(sign))}).right()[0].fraction();
    };
    for (const int sign : {-1, 0, 1}) {
        INFO(sign);
        CHECK(value_for("x > 0", sign) == rational(sign > 0 ? 1 : 0));
        CHECK(value_for("x >= 0", sign) == rational(sign >= 0 ? 1 : 0));
        CHECK(value_for("x ≥ 0", sign) == rational(sign >= 0 ? 1 : 0));
        // The sign is that of x here, too.
        CHECK(value_for("x < 0", sign) == rational(sign < 0 ? 1 : 0));
        CHECK(value_for("x <= 0", sign) == rational(sign <= 0 ? 1 : 0));
    }
    // One sign for both, of x; -x >= 0 is x <= 0.
    const auto both = parse("y' = if(x > 0, 1, 0) + if(-x >= 0, 2, 0); x' = 1; x(0) = 0; y(0) = 0");
    REQUIRE(both.steps.size() == 1);
    CHECK(hybrid_system(both).first_branch({number(rational(0))}).right()[0].fraction() == rational(2));
    CHECK(hybrid_system(both).first_branch({number(rational(1))}).right()[0].fraction() == rational(1));
}

TEST_CASE("events and piecewise functions are refused with the remedy", "[ode][parse][hybrid]") {
    check_refused("y' = 1; y(0) = 0; when y = 1", "has no colon");
    check_refused("y' = 1; y(0) = 0; when : y = 0", "has no condition");
    check_refused("y' = 1; y(0) = 0; when y = 1:", "is not followed by a new value");
    check_refused("y' = 1; y(0) = 0; when y = 1: y' = 2", "is not followed by a new value");
    check_refused("y' = 1; y(0) = 0; when 2 = 1: y = 2", "does not depend on the solution");
    check_refused("y' < 1; y(0) = 0", "is not an equation: write =");
    check_refused("y' = 1: y(0) = 0", "is not expected here");
    check_refused("y' = if(y, 1, 2); y(0) = 0", "is not a comparison: write if(x > 0, a, b)");
    check_refused("y' = if(y > 0, 1); y(0) = 0", "another number of arguments than 3: write if(x > 0, a, b)");
    check_refused("y' = abs(y, 1); y(0) = 0", "another number of arguments than 1: write abs(x)");
    check_refused("y' = y; y(0) = abs(2)", "is piecewise, which is supported only in equations");
}

}  // namespace ode_hybrid_text_test
