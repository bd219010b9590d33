// Events of solutions with delays against closed forms.
#include "libration/query/delay_events.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/delay/delay_rule.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace query_delay_events_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long digits = 30;

event_report events_of(const std::string& problem, const std::string& condition, event_request asked = {}) {
    const equation_system given = parse(problem);
    asked.g = parse_condition(given, condition);
    return searched_delay_events(delay_system(given), asked, digits);
}

void check_number(const known_value& found, const ball& exact) {
    REQUIRE(found.decimal);
    INFO(found.decimal->text << " should be " << tests::text_of(exact));
    CHECK(tests::within_a_unit(*found.decimal, exact, digits));
}

}  // namespace

// 1 + t up to t = 1, then 2 + s + s^2/2, s = t - 1.
TEST_CASE("an event behind a breaking point", "[ode][delay][events]") {
    const precision_scope scope(100);
    const std::string problem = "x' = x(t - 1); x(t <= 0) = 1";
    const auto found = events_of(problem, "x = 3");
    REQUIRE(found.events.size() == 1);
    check_number(found.events[0].time, sqrt(ball(3)));
    CHECK(found.events[0].values[0].decimal->text == "3.00000000000000000000000000000");
    // Beside the breaking point on both sides, and at it.
    for (const long n : {-1L, 0L, 1L}) {
        const ball s = ball(n) / 1000000;
        const auto near = events_of(problem, "x = 2 + (" + std::to_string(n) + "/1000000)");
        check_number(near.events[0].time, n > 0 ? ball(sqrt(ball(1) + s * 2)) : ball(ball(1) + s));
    }
    CHECK(events_of(problem, "x = 1", {.g = {}, .horizon = 20}).events.empty());
    CHECK(events_of(problem, "x = 1", {.g = {}, .from_start = true}).events.size() == 1);
}

// cos(pi t/2)' = -pi/2 cos(pi (t - 1)/2): its zeros are breaking points.
TEST_CASE("events at breaking points", "[ode][delay][events]") {
    const precision_scope scope(100);
    const std::string problem = "x' = -pi/2*x(t - 1); x(t <= 0) = cos(pi*t/2)";
    const auto zeros = events_of(problem, "x = 0", {.g = {}, .count = 4});
    REQUIRE(zeros.events.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        check_number(zeros.events[k].time, ball(static_cast<long>(2 * k + 1)));
        CHECK(zeros.events[k].values[0].decimal->text == "0");
    }
    const auto halves = events_of(problem, "x = 1/2", {.g = {}, .count = 3});
    check_number(halves.events[0].time, ball(2) / 3);
    check_number(halves.events[1].time, ball(10) / 3);
    check_number(halves.events[2].time, ball(14) / 3);
    const auto up = events_of(problem, "x = 1/2", {.g = {}, .way = crossing::up});
    check_number(up.events[0].time, ball(10) / 3);
}

// sin(t)'' = sin(t - pi), with breaking points that are balls, and one for the start.
TEST_CASE("events at breaking points that are no fractions", "[ode][delay][events]") {
    const precision_scope scope(100);
    const std::string problem = "x'' = x(t - pi); x(t <= 0) = sin(t)";
    const auto zeros = events_of(problem, "x = 0", {.g = {}, .count = 3});
    REQUIRE(zeros.events.size() == 3);
    const auto turns = events_of(problem, "x' = 0", {.g = {}, .count = 2});
    for (long k = 0; k < 3; ++k) {
        check_number(zeros.events[static_cast<std::size_t>(k)].time, pi<ball>() * (k + 1));
        check_number(zeros.events[static_cast<std::size_t>(k)].values[1], ball(k % 2 == 0 ? -1 : 1));
    }
    check_number(turns.events[1].time, pi<ball>() * 3 / 2);
    const auto above = events_of(problem, "x = t/2", {.g = {}, .count = 2, .before = number(5)});
    REQUIRE(above.events.size() == 1);
    REQUIRE(above.missing);
    CHECK_THAT(above.missing->what(), Catch::Contains("is not found before that time: 1 were found"));
    // sin t = t/2 (mpmath.findroot(lambda t: sin(t) - t/2, 2)).
    check_number(above.events[0].time, ball(mpfr("1.89549426703398094714403573809360")));
}

// In few bits the enclosures are as wide as their errors.
TEST_CASE("enclosures of events contain them in any precision", "[ode][delay][events]") {
    const precision_scope scope(100);
    for (const std::string delay : {"1", "pi/3"}) {
        const equation_system given =
            parse("x' = -pi/2/(" + delay + ")*x(t - " + delay + "); x(t <= 0) = cos(pi*t/2/(" + delay + "))");
        const delay_system system(given);
        const auto g = parse_condition(given, "x = 0");
        for (const long bits : {40L, 50L, 64L}) {
            INFO(delay << ", " << bits << " bits");
            integration along({constant_value<ball>::of(system.point()), {}, {}, {}},
                              std::make_shared<delay_rule>(system, bits), infinite_distance(1), bits);
            zero_search search(system.first_equations(), g, along, bits);
            const ball unit = constant_value<ball>::of(parse_constant(delay).constant());
            for (long k = 0; k < 6; ++k) {
                const auto event = search.next(crossing::any, std::nullopt);
                REQUIRE(event);
                INFO(tests::text_of(event->time));
                CHECK(arb_overlaps(event->time.handle(), ball(unit * (2 * k + 1)).handle()) != 0);
            }
        }
    }
}

TEST_CASE("a search along a solution with delays ends with its reason", "[ode][delay][events]") {
    const std::string growth = "x' = x(t - 1); x(t <= 0) = 1";
    const auto reason = [](const event_report& report) { return std::string(report.missing.value().what()); };
    CHECK_THAT(reason(events_of(growth, "x = 1/2", {.g = {}, .horizon = 20})),
               Catch::Contains("is not found within 20 steps, from time 0 up to"));
    CHECK_THAT(reason(events_of(growth, "x = 2", {.g = {}, .before = number(1)})), Catch::Contains("lies in"));
    CHECK_THAT(reason(events_of("x' = x^2 + x(t - 1); x(t <= 0) = 1", "x = -1")),
               Catch::Contains("the solution is proved to exist up to 0."));
    CHECK_THROWS_WITH(events_of(growth, "x = 2", {.g = {}, .before = number(-1), .direction = -1}),
                      Catch::Contains("is before the initial point"));
    CHECK_THROWS_WITH(events_of(growth, "x(t - 1) = 2"), Catch::Contains("x"));
}

}  // namespace query_delay_events_test
