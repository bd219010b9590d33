// Events against closed forms: where trigonometric and elliptic functions are 0, and where no bits decide.
#include "libration/ode/proved/proved_events.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/ode/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace ode_proved_proved_events_test {

using namespace libration;
using namespace libration::ode;

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

// The printed decimal is less than one unit of its last digit away from the number.
bool within_a_unit(const proved_decimal& printed, const ball& number, long digits) {
    const precision_scope scope(digits + 30);
    mpfr value;
    mpfr_set_str(handle(value), printed.text.c_str(), 10, MPFR_RNDN);
    return certainly_less(abs(ball(value) - number), abs(number) * pow(ball(10), 1 - digits));
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
    CHECK_THROWS_WITH(events_of("y'' = -y; y(0) = 1; y'(0) = 0", "y = 1", 1, 20), Catch::Contains("touches 0"));
    CHECK_THROWS_WITH(events_of("y' = y^2; y(0) = 1", "y = -1", 1, 20), Catch::Contains("proved to exist"));
    CHECK_THROWS_WITH(events_of("y' = y; y(0) = 1", "y' = 2", 1, 20), Catch::Contains("no part of the state"));
    const auto system = parse("y'' = -y; y(0) = 0; y'(0) = 1");
    event_request request;
    request.g = parse_condition(system, "y = 0");
    request.count = 4;
    request.before = number(rational(10));
    CHECK_THROWS_WITH(proved_events(explicit_system(system), request, 20), Catch::Contains("3 were found"));
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

}  // namespace ode_proved_proved_events_test
