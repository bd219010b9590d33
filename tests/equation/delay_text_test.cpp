// Delays and histories in the text of a problem.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/breaking_points.hpp"
#include "libration/equation/delay_system.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/equation/unused_parameters.hpp"

namespace ode_delay_text_test {

using namespace libration;
using namespace libration::ode;

namespace {

void check_rejected(const std::string& text, const std::string& reason) {
    INFO(text);
    CHECK_THROWS_WITH(delay_system(parse(text)), Catch::Contains(reason));
}

bool is_fraction(const number& x, long p, long q) {
    const auto fraction = x.fraction();
    return fraction && *fraction == rational(p, q);
}

const std::string linear = "x' = -x(t - 1); x(t <= 0) = 1";

}  // namespace

TEST_CASE("delays are read as values of unknowns at earlier times, equal ones once", "[ode][parse][delay]") {
    const auto system = parse(
        "x'' = -x(t - tau) + y(t-tau)*x'(t - 2*tau)^2 - x(t - tau)\n"
        "y' = y(-1/2 + t) + x(t)\n"
        "x(t <= 0) = 1 + k*t, y(t ≤ 0) = 1/2\n"
        "tau = 2; k = 3");
    REQUIRE(system.delays.size() == 4);
    CHECK(same_form(system.delays[0].of, unknown("x")));
    CHECK(same_form(system.delays[0].delay, parameter("tau")));
    CHECK(same_form(system.delays[2].of, unknown("x", 1)));
    CHECK(same_form(system.delays[3].delay, ode::expression(rational(1, 2))));
    REQUIRE(system.histories.size() == 2);
    CHECK(system.histories[0].unknown == "x");
    CHECK(same_form(system.histories[0].value, 1 + parameter("k") * variable()));
    CHECK(system.has_delays());
    CHECK(system.is_smooth());
    CHECK_FALSE(system.is_ordinary());
    CHECK(unused_parameters("x' = -x(t - tau); x(t <= 0) = k; tau = 1; k = 1").empty());
    CHECK(parse("x' = -x(t - tau); x(t <= 0) = k").open.size() == 2);
    CHECK(parse("y' = y(x - 1); y(x <= 0) = 1").variable == "x");
    CHECK(parse("y' = y(s - 1); y(s <= 0) = 1").variable == "s");
    CHECK(same_form(changed(parse(linear), "x(t <= 0) = 2 + t").histories[0].value, 2 + variable()));
    const auto named = parse("x' = -x(t - 1) + r; r = x^2; x(t <= 0) = s; s = 1 + t");
    CHECK(same_form(named.equations[0].right, -parameter(named.delays[0].parameter) + pow(unknown("x"), 2)));
    CHECK(same_form(named.histories[0].value, 1 + variable()));
    CHECK(canonical_text(linear) == "x' = -x(t - 1)\nx(t <= 0) = 1\n");
}

TEST_CASE("the initial values are those of the history", "[ode][delay]") {
    const delay_system system(parse("x'' = -x'(t - 1) - y; y' = x(t - 1/2)^2; x(t <= 1) = t^3; y(1) = 5"));
    REQUIRE(system.leaves().size() == 3);
    CHECK(names_of_state(system) == std::vector<std::string>{"x", "x'", "y"});
    CHECK(is_fraction(system.point(), 1, 1));
    CHECK(is_fraction(system.starts()[0], 1, 1));
    CHECK(is_fraction(system.starts()[1], 3, 1));
    CHECK(is_fraction(system.starts()[2], 5, 1));
    REQUIRE(system.delays().size() == 2);
    CHECK(is_fraction(system.delays()[0], 1, 2));
    const delay_stage first = system.first_stage();
    CHECK(first.inputs.empty());
    const delay_stage last = system.stage(2, number(rational(2)), system.starts(), std::vector<number>(4));
    CHECK(last.inputs.size() == 2);
    REQUIRE(last.system.unknowns().size() == 7);
    CHECK(last.system.unknowns()[1].name == "x'");
    CHECK(last.inputs[1].slope == 6);
}

TEST_CASE("problems in C++ have delays too", "[ode][delay]") {
    const auto x = unknown("x");
    equation_system made;
    made.add(derivative(x), -made.delayed(x, 1) * made.delayed(x, 1)).before(x, 2 + variable());
    CHECK(made.delays.size() == 1);
    CHECK(is_fraction(delay_system(made).starts()[0], 2, 1));
}

TEST_CASE("breaking points are sums of delays, each once", "[ode][delay]") {
    breaking_points points(number(rational(1)), {number(rational(1, 2)), number(rational(3, 4))});
    CHECK(is_fraction(points[0], 1, 1));
    CHECK(is_fraction(points[1], 3, 2));
    CHECK(is_fraction(points[2], 7, 4));
    CHECK(is_fraction(points[3], 2, 1));
    CHECK(is_fraction(points[4], 9, 4));
    CHECK(is_fraction(points[5], 5, 2));
    breaking_points of_pi(number(), {number(rational(3)), number(rational(1), unit::pi)});
    CHECK((of_pi[4] - number(rational(1), unit::pi) - number(rational(3))).sign() == 0);
}

TEST_CASE("delays that are not supported have their reasons", "[ode][parse][delay]") {
    check_rejected("x' = -x(t + 1); x(t <= 0) = 1", "is not at an earlier time: write x(t - delay) with a positive");
    check_rejected("x' = -x(t - x); x(t <= 0) = 1", "has a delay that is not constant: write x(t - delay)");
    check_rejected("x' = -x(t/2); x(t <= 0) = 1", "has a delay that is not constant");
    check_rejected("x' = -x(t - k); x(t <= 0) = 1; k = -1", "has a delay that is not positive");
    check_rejected("x' = -x''(t - 1); x(t <= 0) = 1", "is a delayed derivative that is higher than the highest one");
    check_rejected("2*x' = -x'(t - 1); x(t <= 0) = 1", "is delayed, which is supported only with an equation x' = ...");
    check_rejected("x' = y' + x'(t - 1); y' = 1; x(t <= 0) = 1; y(0) = 1", "has a highest derivative on the right");
    check_rejected("x' = -x'(t - 1); x(0) = 1", "is delayed and has no history: add x(t <= 0) = number");
    check_rejected("x' = -x(t - 1); x(0) = 1", "is delayed and has no history: add x(t <= 0) = number");
    check_rejected("x' = -x(t - 1); x(t <= 0) = 1; x(0) = 1", "has a history, which contains the initial value");
    check_rejected("x' = -x; x(t <= 0) = 1", "has a history and is not delayed");
    check_rejected("x' = -x(t - 1); x(t < 0) = 1", "is not the history of an unknown: write x(t <= 0) = 1");
    check_rejected("x' = -x(t - 1); y(t <= 0) = 1", "is not the history of an unknown");
    check_rejected("x' = -x(t - 1); x(t <= 0) = x", "has an unknown on its right-hand side");
    check_rejected("x' = -x(t - 1); x(t <= 0) = 1, x(t <= 0) = 2", "gives x a second history");
    check_rejected("x' = -x(t - 1); x(t <= 0) = 1/t", "has a history that has no value at the initial point");
    check_rejected("x' = -x(t - 1)/t; x(t <= 0) = 1", "has a singular initial point");
    check_rejected("x' = -x(0); x(t <= 0) = 1", "is ambiguous: write");
    check_rejected("x' = -x(t - 1) + y; 0 = y - x; x(t <= 0) = 1; y(0) = 1", "has an algebraic equation");
    check_rejected("x' = -x(t - d); x(t <= 0) = 1; d = x", "depends on the solution");
    CHECK_THROWS_WITH(parse("x' = 1; x(0) = 0; invariant x(t - 1)"),
                      Catch::Contains("is a delayed unknown, which is supported only in equations"));
    CHECK_THROWS_WITH(explicit_system(parse(linear)),
                      "problem 'x' at line 1, column 7 is delayed, which is supported for values at times (reference, "
                      "trajectory) alone: leave it out");
    CHECK_THROWS_WITH(hybrid_system(parse("x' = -x(t - 1); x(t <= 0) = 1; when x = 0: stop")),
                      Catch::Contains("is not supported together with events"));
}

}  // namespace ode_delay_text_test
