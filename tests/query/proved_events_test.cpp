// Events against closed forms: where trigonometric and elliptic functions are 0, and where no bits decide.
#include "libration/query/proved_events.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace query_proved_events_test {

using namespace libration;
using namespace libration::ode;
using tests::within_a_unit;

namespace {

std::vector<printed_event> events_of(const std::string& text, const std::string& condition, long count, long digits,
                                     crossing way = crossing::any) {
    const auto system = parse(text);
    event_request request;
    request.g = parse_condition(system, condition);
    request.count = count;
    request.way = way;
    return proved_events(explicit_system(system), request, digits);
}

}  // namespace

TEST_CASE("the zeros of sine are the multiples of pi, all of them, in their order", "[ode][proved]") {
    const auto all = events_of("y'' = -y; y(0) = 0; y'(0) = 1", "y = 0", 12, 40);
    const precision_scope scope(80);
    REQUIRE(all.size() == 12);
    for (int k = 1; k <= 12; ++k) {
        CHECK(within_a_unit(all[static_cast<std::size_t>(k) - 1].time, pi<ball>() * k, 40));
        CHECK(all[static_cast<std::size_t>(k) - 1].values[0].text == "0");
    }
    const auto up = events_of("y'' = -y; y(0) = 0; y'(0) = 1", "y = 0", 3, 40, crossing::up);
    for (int k = 1; k <= 3; ++k) {
        CHECK(within_a_unit(up[static_cast<std::size_t>(k) - 1].time, pi<ball>() * (2 * k), 40));
    }
    const auto half = events_of("y'' = -y; y(0) = 0; y'(0) = 1", "2*y = 1", 2, 40);
    CHECK(within_a_unit(half[0].time, pi<ball>() / 6, 40));
    CHECK(within_a_unit(half[1].time, pi<ball>() * 5 / 6, 40));
    CHECK(half[0].values[0].text.substr(0, 6) == "0.5000");
}

// x'^2/2 + 1 - cos x = E: a quarter period is the time of the first zero; `reference --theta0 2 --omega0 0 --time
// T/4,3T/4`.
TEST_CASE("the quarter periods of the pendulum are events of its equation", "[ode][proved]") {
    const auto found = events_of("x'' = -sin(x); x(0) = 2; x'(0) = 0", "x = 0", 2, 40);
    CHECK(found[0].time.text == "2.087438231729623683601592911475967535995");
    CHECK(found[1].time.text == "6.262314695188871050804778734427902607984");
    const auto turns = events_of("x'' = -sin(x); x(0) = 2; x'(0) = 0", "x' = 0", 1, 30);
    CHECK(turns[0].time.text == "4.17487646345924736720318582295");
    CHECK(turns[0].values[0].text == "-2.00000000000000000000000000000");
}

TEST_CASE("conditions may hold the time and functions", "[ode][proved]") {
    CHECK(events_of("y' = 1; y(0) = 1", "1/y = 1/4", 1, 20).front().time.text == "3.0000000000000000000");
    CHECK_THROWS_WITH(events_of("y' = 1; y(0) = 0", "1/y = 1/4", 1, 20), Catch::Contains("divides by zero"));
    // e^t = 2 + t^2 has one root: g changes sign there; enclosed against itself by exp of balls.
    const auto found = events_of("y' = y; y(0) = 1", "y = 2 + t^2", 1, 30);
    const precision_scope scope(60);
    mpfr t;
    mpfr_set_str(handle(t), found[0].time.text.c_str(), 10, MPFR_RNDN);
    const ball unit = pow(ball(10), -28L);
    const auto g = [](const ball& x) { return exp(x) - x * x - 2; };
    CHECK(certainly_less(g(ball(t) - unit), ball(0)));
    CHECK(certainly_less(ball(0), g(ball(t) + unit)));
}

TEST_CASE("what touches 0 is not decided, and an event that does not come before the end is none", "[ode][proved]") {
    CHECK_THROWS_WITH(events_of("y'' = -y; y(0) = 1; y'(0) = 0", "y = 1", 1, 20),
                      Catch::Contains("is not decided by") && Catch::Contains("[6.28318530717, 6.28318530718]"));
    CHECK_THROWS_WITH(events_of("y' = y^2; y(0) = 1", "y = -1", 1, 20), Catch::Contains("proved to exist"));
    CHECK_THROWS_WITH(events_of("y' = y; y(0) = 1", "y' = 2", 1, 20), Catch::Contains("not part of the state"));
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    event_request request;
    request.g = parse_condition(system, "y = 0");
    request.count = 4;
    request.before = number(rational(10));
    CHECK_THROWS_WITH(proved_events(explicit_system(system), request, 20), Catch::Contains("3 were found"));
}

// The first zero of Lane and Emden's function of index 3/2 is at 3.65375373622.
TEST_CASE("an event where a root of it ends is refused with the reason, and a small value is found", "[ode][proved]") {
    const std::string star = "y'' + 2/x*y' = -y^(3/2); y(0) = 1; y'(0) = 0";
    CHECK_THROWS_WITH(events_of(star, "y = 0", 1, 15), Catch::Contains("search for a small value instead"));
    CHECK(events_of(star, "y = 10^-15", 1, 12).front().time.text == "3.65375373622");
    CHECK_THROWS_WITH(events_of("y' = y^2; y(0) = 1", "y = -1", 1, 15), !Catch::Contains("small value"));
}

TEST_CASE("zeros of higher order of functions of the time are found at exact numbers", "[ode][proved]") {
    const std::string growth = "y' = y; y(0) = 1";
    const std::string product = "(t - 1)^2*(t - 3)^3*(t - 4) = 0";
    const auto found = events_of(growth, product, 3, 20);
    const std::vector<long> times{1, 3, 4};
    for (std::size_t i = 0; i < times.size(); ++i) {
        CHECK(mpfr(found[i].time.text) == times[i]);
    }
    const auto first = [&](crossing way) { return mpfr(events_of(growth, product, 1, 20, way)[0].time.text); };
    CHECK(first(crossing::down) == 3);
    CHECK(first(crossing::up) == 4);
    CHECK(within_a_unit(events_of(growth, "1 - sin(t) = 0", 1, 20)[0].time, pi<ball>() / 2, 20));
    // No zero of order 2, but two simple ones, or none.
    CHECK(events_of(growth, "(t - 1)^2 = 1e-30", 2, 20).size() == 2);
    const auto system = parse(growth);
    event_request request;
    request.g = parse_condition(system, "(t - 1)^2 + 1e-30 = 0");
    request.before = number(rational(2));
    CHECK_THROWS_AS(proved_events(explicit_system(system), request, 20), error);
}

TEST_CASE("backwards in time the first event is the last one before the start", "[ode][proved]") {
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    event_request request;
    request.g = parse_condition(system, "y = 0");
    request.count = 2;
    request.direction = -1;
    const auto found = proved_events(explicit_system(system), request, 30);
    const precision_scope scope(60);
    CHECK(within_a_unit(found[0].time, -pi<ball>(), 30));
    CHECK(within_a_unit(found[1].time, pi<ball>() * -2, 30));
}

// Sections next to the start, which numbers of the working precision do not tell from it.
TEST_CASE("no event is at the start or before it", "[ode][proved][events]") {
    const auto missing = [](const std::string& text, const std::string& condition) {
        const auto system = parse(text);
        event_request request;
        request.g = parse_condition(system, condition);
        request.before = number(rational(2));
        const auto report = searched_events(explicit_system(system), request, 30);
        CHECK(report.events.empty());
        return std::string(report.missing ? report.missing->what() : "");
    };
    CHECK_THAT(missing("y' = 1; y(1) = 1 + 1e-400", "y = 1"), Catch::Contains("0 were found"));
    CHECK_THAT(missing("y' = 1; y(1) = 1", "y = 1"), Catch::Contains("0 were found"));
    CHECK_THAT(missing("y'' = -y; y(1) = pi/3 + pi/6; y'(1) = 1", "y = pi/2"), Catch::Contains("0 were found"));
    CHECK_THAT(missing("y'' = -y; y(1) = 2*asin(sqrt(1/2)); y'(1) = 1", "y = pi/2"), Catch::Contains("is not decided"));
    CHECK_THAT(missing("y' = y; y(1) = 0", "y = 0"), Catch::Contains("derivatives hold there"));
    CHECK_THAT(missing("y''' = 1; y(0) = 0; y'(0) = 0; y''(0) = 0", "y = 0"), Catch::Contains("0 were found"));
    const auto late = events_of("x'' = -x; x(1) = 1 + 1e-51; x'(1) = 1", "x = 1", 1, 40);
    const precision_scope scope(80);
    // A sin t + B cos t about 1, with A = B to 50 digits.
    CHECK(within_a_unit(late.front().time, ball(1) + atan2(ball(1), pow(ball(10), -51) + 1) * 2, 40));
}

TEST_CASE("the start is an event where that is asked for", "[ode][proved][events]") {
    const auto system = parse("y'' = -y; y(2) = pi/2; y'(2) = 1");
    event_request request;
    request.g = parse_condition(system, "y = pi/2");
    request.from_start = true;
    request.way = crossing::up;
    const auto first = proved_events(explicit_system(system), request, 20).front();
    CHECK(first.time.text == "2.0000000000000000000");
    CHECK(first.time.uncertainty == "0");
    request.way = crossing::down;
    CHECK(proved_events(explicit_system(system), request, 20).front().time.text != "2.0000000000000000000");
}

// y = t from elsewhere, y = t^2 from rest, and y = 1 - t.
TEST_CASE("the start is no event, one that touches 0, and one that falls", "[ode][proved][events]") {
    const auto first = [](const std::string& text, const std::string& condition, crossing way) {
        const auto system = parse(text);
        event_request request;
        request.g = parse_condition(system, condition);
        request.from_start = true;
        request.way = way;
        request.before = number(rational(2));
        const auto report = searched_events(explicit_system(system), request, 20);
        return report.events.empty() ? std::string() : report.events.front().time.decimal.value().text;
    };
    CHECK(first("y' = 1; y(0) = 0", "y = 1", crossing::any) == "1.0000000000000000000");
    CHECK(first("y'' = 2; y(0) = 0; y'(0) = 0", "y = 0", crossing::any) == "0");
    CHECK(first("y'' = 2; y(0) = 0; y'(0) = 0", "y = 0", crossing::up).empty());
    CHECK(first("y' = -1; y(0) = 1", "y = 1", crossing::down) == "0");
    CHECK(first("y' = -1; y(0) = 1", "y = 1", crossing::up).empty());
}

TEST_CASE("events are certainly before the end, or refused with their bounds", "[ode][proved][events]") {
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    const auto found = [&](const std::string& condition, const std::string& end, long count) {
        event_request request;
        request.g = parse_condition(system, condition);
        request.before = parse_constant(end).constant();
        request.direction = request.before->sign();
        request.count = count;
        return searched_events(explicit_system(system), request, 20);
    };
    CHECK_THAT(found("y = 0", "1e-10", 1).missing->what(), Catch::Contains("0 were found"));
    CHECK_THAT(found("y = 1/2", "0.1", 2).missing->what(), Catch::Contains("0 were found"));
    CHECK_THAT(found("y = -1/2", "-0.1", 2).missing->what(), Catch::Contains("0 were found"));
    CHECK_THAT(found("y = -1/2", "-0.6", 2).missing->what(), Catch::Contains("1 were found"));
    CHECK(found("y = 1/2", "1", 2).events.size() == 1);
    CHECK(found("y = 1/2", "pi/6 + 1e-30", 1).events.size() == 1);
    CHECK(found("y = 1/2", "pi/6 - 1e-30", 1).events.empty());
    for (const std::string end : {"pi/6", "-7*pi/6"}) {
        const auto open = found("y = 1/2", end, 1);
        CHECK(open.events.empty());
        CHECK_THAT(open.missing->what(), Catch::Contains("do not distinguish from the end of the search"));
    }
    CHECK_THAT(found("y = 1/2", "pi/6", 1).missing->what(), Catch::Contains("[0.523598775598, 0.523598775599]"));
}

TEST_CASE("a search without an end gives up", "[ode][proved][events]") {
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    event_request request;
    request.g = parse_condition(system, "y = 2");
    request.horizon = 20;
    const auto report = searched_events(explicit_system(system), request, 20);
    REQUIRE(report.missing);
    CHECK_THAT(report.missing->what(), Catch::Contains("is not found within 20 steps, from time 0 up to "));
}

// sin t = 1/2 at (1, 5, 13, 17 ..) pi/6; the first two of these are in the same step.
TEST_CASE("a search continues up to another end, later or earlier", "[ode][proved][events]") {
    const explicit_system system(parse("y'' = -y; y(0) = 0; y'(0) = 1"));
    const precision_scope scope(60);
    zero_search search(system, ode::unknown("y") - ode::expression(rational(1, 2)), 120);
    const auto is_next = [&](int sixths, const std::optional<number>& end) {
        const auto event = search.next(crossing::any, end);
        return event && overlaps(event->time, pi<ball>() * sixths / 6) &&
               certainly_less(radius_of(event->time), pow(ball(10), -20));
    };
    const auto has_none = [&](const rational& end) {
        return !search.next(crossing::any, number(end)) && search.end() == search_end::time;
    };
    for (const int percent : {25, 12, 25, 50}) {
        CAPTURE(percent);
        CHECK(has_none(rational(percent, 100)));
    }
    CHECK(is_next(1, std::nullopt));
    for (const int end : {1, 2, 1}) {
        CAPTURE(end);
        CHECK(has_none(end));
    }
    CHECK(is_next(5, number(rational(3))));
    CHECK(has_none(6));
    CHECK(is_next(13, std::nullopt));
    CHECK(is_next(17, number(rational(100))));
}

TEST_CASE("two events about a turn, and one far away from where nothing has a length", "[ode][proved][events]") {
    const precision_scope scope(80);
    const auto twins = events_of("y'' = -y; y(0) = 0; y'(0) = 1", "y = 1 - 1e-30", 2, 40);
    const ball away = acos(ball(1) - pow(ball(10), -30));
    CHECK(within_a_unit(twins[0].time, pi<ball>() / 2 - away, 40));
    CHECK(within_a_unit(twins[1].time, pi<ball>() / 2 + away, 40));
    CHECK(within_a_unit(events_of("y'' = -9.81; y(0) = 1; y'(0) = 0", "y = 0", 1, 40).front().time,
                        sqrt(ball(200) / 981), 40));
}

// y = sin t: y' = cos t is -1 at -pi and 1 at -2 pi.
TEST_CASE("up and down are those of increasing time, also backwards", "[ode][proved][events]") {
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    event_request request;
    request.g = parse_condition(system, "y = 0");
    request.direction = -1;
    const precision_scope scope(60);
    request.way = crossing::down;
    CHECK(within_a_unit(proved_events(explicit_system(system), request, 30).front().time, -pi<ball>(), 30));
    request.way = crossing::up;
    CHECK(within_a_unit(proved_events(explicit_system(system), request, 30).front().time, pi<ball>() * -2, 30));
}

// x = t - 1 and u = tan(t - 1), which are 0 at the first event.
TEST_CASE("a number of an event that is exactly 0 has a bound, and the others have their digits", "[ode][proved]") {
    const auto system = parse("x' = 1; u' = 1 + u^2; x(0) = -1; u(0) = -tan(1)");
    event_request request;
    request.g = parse_condition(system, "x*(2*x - 1) = 0");
    request.count = 2;
    const auto report = searched_events(explicit_system(system), request, 20);
    REQUIRE(report.events.size() == 2);
    CHECK_FALSE(report.events[0].is_complete());
    CHECK(report.events[0].time.decimal.value().text == "1.0000000000000000000");
    CHECK(report.events[0].values[0].decimal.value().text == "0");
    const known_value& zero = report.events[0].values[1];
    CHECK_FALSE(zero.decimal);
    CHECK(mpfr(zero.bound) > 0);
    CHECK(mpfr(zero.bound) < mpfr("1e-60"));
    CHECK(report.events[1].time.decimal.value().text == "1.5000000000000000000");
    CHECK(report.events[1].values[0].decimal.value().text == "0.50000000000000000000");
    const precision_scope scope(60);
    CHECK(within_a_unit(report.events[1].values[1].decimal.value(), tan(ball(1) / 2), 20));
    REQUIRE(report.missing);
    CHECK_THAT(report.missing->what(), Catch::StartsWith("event '1' has a value of u that ") &&
                                           Catch::Contains("do not distinguish from 0: |u| < "));
    CHECK_THROWS_WITH(proved_events(explicit_system(system), request, 20), Catch::Contains("distinguish from 0"));
}

TEST_CASE("the time of an event may be 0, and fewer events than requested are the reason before that",
          "[ode][proved]") {
    const auto system = parse("y' = 1 + y^2; y(-1) = -tan(1)");
    event_request request;
    request.g = parse_condition(system, "y = 0");
    const auto alone = searched_events(explicit_system(system), request, 20);
    REQUIRE(alone.events.size() == 1);
    CHECK_FALSE(alone.events[0].time.decimal);
    CHECK(mpfr(alone.events[0].time.bound) < mpfr("1e-60"));
    CHECK(alone.events[0].values[0].decimal.value().text == "0");
    CHECK_THAT(alone.missing.value().what(), Catch::Contains("has a value of time that "));
    request.count = 2;
    request.before = number(rational(1));
    const auto more = searched_events(explicit_system(system), request, 20);
    REQUIRE(more.events.size() == 1);
    CHECK(mpfr(more.events[0].time.bound) < mpfr("1e-60"));
    CHECK_THAT(more.missing.value().what(), Catch::Contains("event '2' is not found before that time: 1 were found"));
}

// v = sin t where t is pi rounded to 200 digits: far below the precision of the first runs for 20 digits.
TEST_CASE("a tiny number of an event has its digits", "[ode][proved]") {
    const precision_scope scope(300);
    const std::string t = to_decimal(midpoint_of(pi<ball>()), 200);
    const auto found = events_of("x' = 1; v'' = -v; x(0) = 0; v(0) = 0; v'(0) = 1", "x = " + t, 1, 20);
    const ball rest = pi<ball>() - constant_value<ball>::of(parse_constant(t).constant());
    CHECK(within_a_unit(found[0].values[1], rest, 20));
}

}  // namespace query_proved_events_test
