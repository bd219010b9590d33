// Enclosures of the events of all solutions of a set against closed forms of their ranges.
#include "libration/query/sets/set_events.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "query/sets/set_ranges.hpp"

namespace query_sets_set_events_test {

using namespace libration;
using namespace libration::ode;
using tests::check_range;
using tests::digits_of_ranges;
using tests::sharp;
using tests::value_of;

namespace {

set_events events_of(const std::string& problem, const set_event_request& asked) {
    return enclosed_events(parse(problem), asked);
}

// The radii of sets have 30 bits.
void check_value(const closed_interval& found, const ball& exact) {
    CHECK_FALSE(certainly_less(exact, found.lower));
    CHECK_FALSE(certainly_less(found.upper, exact));
    CHECK(certainly_less(found.upper - found.lower, pow(ball(2), -26)));
}

std::string missing_of(const std::string& problem, const set_event_request& asked) {
    const auto found = events_of(problem, asked);
    REQUIRE(found.missing);
    CHECK(found.missing->kind() == error_kind::undecided);
    return found.missing->what();
}

}  // namespace

// y = h - g t^2/2: t = sqrt(2 h/g) with y' = -sqrt(2 g h). Then the speed increases with h and g, the time with h alone.
TEST_CASE("the events of a set are those of the extreme solutions", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const auto fall = events_of("y'' = -g; y(0) = [0.9, 1.1]; y'(0) = 0; g = [9.7, 9.9]", {.condition = "y = 0"});
    CHECK(fall.names == std::vector<std::string>{"y", "y'"});
    REQUIRE(fall.events.size() == 1);
    const auto& ground = fall.events.front();
    check_range(ground.time, sqrt(value_of("1.8/9.9")), sqrt(value_of("2.2/9.7")), sharp);
    check_value(ground.values[0], ball(0));
    check_range(ground.values[1], -sqrt(value_of("2.2*9.9")), -sqrt(value_of("1.8*9.7")), sharp);
    CHECK_FALSE(fall.missing);

    // x' = -x from s to a: ln(s/a); a set of the condition alone, of the equation, and through a parameter.
    const auto to_set = events_of("x' = -x; x(0) = [0.9, 1.1]; a = [0.4, 0.5]", {.condition = "2*x = 2*a"});
    check_range(to_set.events[0].time, log(value_of("0.9/0.5")), log(value_of("1.1/0.4")), sharp);
    check_range(to_set.events[0].values[0], value_of("0.4"), value_of("0.5"), sharp);
    const auto both = events_of("x' = -x; x(0) = 1 + a; a = [1, 2]", {.condition = "x = a"});
    check_range(both.events[0].time, log(value_of("3/2")), log(ball(2)), sharp);
    check_range(both.events[0].values[0], ball(1), ball(2), sharp);
    const auto single = events_of("x' = -x; x(0) = 2", {.condition = "x = 1"});
    check_value(single.events[0].time, log(ball(2)));
    CHECK(single.parts == 1);
}

// x = A cos t + B sin t, A, B > 0, is 0 at pi - arctan(A/B) + n pi.
TEST_CASE("events of a set are counted in their order", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const std::string problem = "x'' = -x; x(0) = [1, 2]; x'(0) = [1, 3/2]";
    const ball first = pi<ball>() - atan(ball(2));
    const ball last = pi<ball>() - atan(value_of("2/3"));
    const auto all = events_of(problem, {.condition = "x = 0", .count = 3});
    REQUIRE(all.events.size() == 3);
    for (long n = 0; n < 3; ++n) {
        check_range(all.events[static_cast<std::size_t>(n)].time, first + pi<ball>() * n, last + pi<ball>() * n, sharp);
    }
    check_range(all.events[0].values[1], -sqrt(value_of("4 + 9/4")), -sqrt(ball(2)), sharp);
    const auto up = events_of(problem, {.condition = "x = 0", .way = crossing::up});
    check_range(up.events[0].time, first + pi<ball>(), last + pi<ball>(), sharp);
    const auto back = events_of(problem, {.condition = "x = 0", .count = 2, .before = number(rational(-5))});
    check_range(back.events[0].time, first - pi<ball>(), last - pi<ball>(), sharp);
    check_range(back.events[1].time, first - pi<ball>() * 2, last - pi<ball>() * 2, sharp);
}

// What is 0 at the initial point of all solutions is no event, and the next one is found.
TEST_CASE("events of a set begin after the initial point", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const std::string problem = "x'' = -x; x(0) = 0; x'(0) = [1, 2]";
    const auto found = events_of(problem, {.condition = "x = 0", .count = 2});
    REQUIRE(found.events.size() == 2);
    check_value(found.events[0].time, pi<ball>());
    check_value(found.events[1].time, pi<ball>() * 2);
    check_range(found.events[0].values[1], ball(-2), ball(-1), sharp);
    const auto back = events_of(problem, {.condition = "x = 0", .way = crossing::down, .before = number(-5)});
    check_value(back.events[0].time, -pi<ball>());
    // Some begin at 0, or on the other side.
    for (const std::string start : {"[0, 1]", "[-1, 1]", "[-1/100, 0]"}) {
        CHECK_THAT(missing_of("x'' = -x; x(0) = " + start + "; x'(0) = [1, 2]", {.condition = "x = 0"}),
                   Catch::Contains("may hold at the initial point of some of the solutions"));
    }
}

// 5 - b^2, with its largest value inside; and y at x = 3, y = c sin(pi (2 t/5)), x = s + t, at times from 2 to 3 where
// the sine has both signs.
TEST_CASE("values at events that are not monotone", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const auto square = events_of("x' = 1; x(0) = b^2; b = [-1, 2]", {.condition = "x = 5"});
    check_range(square.events[0].time, ball(1), ball(5), 1.125);
    const std::string turning = "x' = 1; y'' = -(2*pi/5)^2*y; x(0) = [0, 1]; y(0) = 0; y'(0) = 2*pi/5*c; c = [1, 2]";
    for (const std::size_t parts : {1U, 64U}) {
        const auto found = events_of(turning, {.condition = "x = 3", .most_parts = parts});
        check_range(found.events[0].time, ball(2), ball(3), sharp);
        const ball most = sin(pi<ball>() * value_of("4/5")) * 2;
        check_range(found.events[0].values[1], -most, most, 2);
    }
}

TEST_CASE("an event that some solutions do not have is missing", "[ode][proved][sets]") {
    // The amplitude is below 1 for some of them, and 1 for one.
    CHECK_THAT(missing_of("x'' = -x; x(0) = 0; x'(0) = [0.5, 2]", {.condition = "x = 1", .horizon = 20}),
               Catch::Contains("is not found within 20 steps"));
    CHECK_THAT(missing_of("x'' = -x; x(0) = 0; x'(0) = [1, 2]", {.condition = "x = 1", .most_parts = 8}),
               Catch::Contains("is not decided: the condition may hold in [1."));
    const std::string decay = "x' = -x; x(0) = [1, 2]";
    CHECK_THAT(missing_of(decay, {.condition = "x = 1/2", .before = number(rational(1, 2))}),
               Catch::Contains("is not found before that time: 0 were found for x(0) in [1.00000000000"));
    // At ln 2 .. ln 4.
    CHECK_THAT(missing_of(decay, {.condition = "x = 1/2", .before = parse_constant("log(4)").constant()}),
               Catch::Contains("is not proved to be before that time for every solution"));
    CHECK_FALSE(events_of(decay, {.condition = "x = 1/2", .before = number(rational(3, 2))}).missing);
    CHECK_THAT(missing_of(decay, {.condition = "x = 0", .horizon = 10}),
               Catch::Contains("is not found within 10 steps"));
    CHECK_THAT(missing_of("x' = x^2; x(0) = [0.9, 1.1]", {.condition = "x = -1"}),
               Catch::Contains("is not reached by every solution: all of them are proved to exist up to 0.90"));
    // The times of what is undecided do not begin before the initial one.
    CHECK_THAT(missing_of("x' = -a*x^3; x(0) = [1.4551915228366852e-11, 0.01]; a = [1, 1.1]",
                          {.condition = "x = 4.365574568510055e-12", .most_parts = 8}),
               Catch::Contains("the condition may hold in [0, "));
    // The events before the one that is missing are known.
    const auto two =
        events_of("x'' = -x; x(0) = 0; x'(0) = [1, 2]", {.condition = "x = 0", .count = 3, .before = number(7)});
    CHECK(two.events.size() == 2);
    CHECK(two.missing);
}

TEST_CASE("conditions on sets are read like others", "[ode][proved][sets]") {
    const auto refused = [](const std::string& problem, const std::string& condition) -> std::string {
        try {
            events_of(problem, {.condition = condition});
        } catch (const error& of) {
            CHECK(of.kind() == error_kind::argument);
            return of.what();
        }
        return "";
    };
    const std::string decay = "x' = -x; x(0) = [1, 2]";
    CHECK_THAT(refused(decay, "x = c"), Catch::Contains("'c'"));
    CHECK_THAT(refused(decay, "x"), Catch::Contains("is not an equation"));
    CHECK_THAT(refused("x' = if(x > 1, 1, 2); x(0) = [1, 2]", "x = 3"), Catch::Contains("is piecewise"));
    CHECK_THAT(refused("x' = t; x(a) = 1; a = [1, 2]", "x = 3"), Catch::Contains("cannot be the initial point"));
}

}  // namespace query_sets_set_events_test
