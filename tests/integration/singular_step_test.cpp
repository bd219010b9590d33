// Theorem S compared with closed forms: the step from a regular singular initial point, the following ones, and a
// remainder that must be visible.
#include "libration/integration/singular_step.hpp"
#include "libration/equation/constant_value.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/complex_number.hpp"
#include "proved.hpp"

namespace integration_singular_step_test {

using namespace libration;
using namespace libration::ode;

namespace {

equation_system equations(const std::string& n) {
    return changed(parse(std::string(problem_text("lane_emden"))), "n = " + n);
}

explicit_system lane_emden(const std::string& n) { return explicit_system(equations(n)); }

number typed(const std::string& text) { return parse_constant(text).constant(); }

// sin(t)/t for n = 1, (1 + t^2/3)^(-1/2) for n = 5.
ball sinc(const ball& t) { return sin(t) / t; }
ball plummer(const ball& t) { return ball(1) / sqrt(ball(1) + t * t / 3); }

}  // namespace

TEST_CASE("the step from a singular start holds closed forms", "[ode][proved][singular]") {
    for (const long bits : {60L, 200L, 1000L}) {
        INFO(bits);
        const precision_scope scope(decimal_digits(bits) + 30);
        using closed_form = ball (*)(const ball&);
        for (const auto& [n, exact] : {std::pair<const char*, closed_form>{"1", sinc}, {"5", plummer}}) {
            const singular_step step = proved_singular_step(lane_emden(n), bits);
            const ball t = constant_value<ball>::of(step.beyond.point());
            REQUIRE(step.state.size() == 2);
            CHECK(overlaps(step.state[0], exact(t)));
            CHECK(certainly_less(step.state[0] - exact_midpoint(step.state[0]), pow(ball(2), -bits + 4)));
            CHECK(overlaps(step.series->at(t / 3)[0], exact(t / 3)));
        }
        const singular_step step = proved_singular_step(lane_emden("1"), bits);
        const ball t = constant_value<ball>::of(step.beyond.point());
        CHECK(overlaps(step.state[1], cos(t) / t - sin(t) / (t * t)));
    }
}

// With a list that is truncated after a few powers the remainder is as large as the bound, and not much smaller: the
// next power alone is within a factor of a thousand of it, at a quarter of the radius.
TEST_CASE("theorem S bounds what a short list leaves out", "[ode][proved][singular]") {
    const precision_scope scope(60);
    const auto system = lane_emden("5");
    const tape of = tape::about_start(system);
    for (const int degree : {8, 20, 40}) {
        INFO(degree);
        taylor_expansion<ball> expansion(of, degree + 8);
        expansion.about_start();
        const magnitude radius(1U);
        const auto tail = bounded_singular_tail(of, expansion, degree, radius);
        REQUIRE(tail);
        const ball t = ball(1) / 4;
        ball sum(0);
        ball power(1);
        for (int k = 0; k <= degree; ++k, power *= t) {
            sum += expansion.coefficients(0)[k] * power;
        }
        const ball missing = abs(plummer(t) - sum);
        const ball bound = tail->at(0, magnitude::of(1, -2)).exact();
        CHECK(certainly_less(missing, bound));
        CHECK(certainly_less(bound, missing * 1'000));
    }
    // Beyond the radius, sqrt(3), there is no bound.
    taylor_expansion<ball> expansion(of, 48);
    expansion.about_start();
    CHECK_FALSE(bounded_singular_tail(of, expansion, 40, magnitude(2U)));
}

// sin(t)/t: 110 a_10 = -a_8, and so on: the remainder consists of the powers of t beyond the list on the right-hand
// side.
TEST_CASE("theorem S counts what powers of the distance move beyond a list", "[ode][proved][singular]") {
    const precision_scope scope(80);
    const auto system = lane_emden("1");
    const tape of = tape::about_start(system);
    for (const int degree : {9, 21}) {
        INFO(degree);
        taylor_expansion<ball> expansion(of, degree + 8);
        expansion.about_start();
        const auto tail = bounded_singular_tail(of, expansion, degree, magnitude(1U));
        REQUIRE(tail);
        const ball t = ball(1) / 4;
        ball sum(0);
        for (int k = degree; k >= 0; --k) {
            sum = sum * t + expansion.coefficients(0)[k];
        }
        CHECK(certainly_less(abs(sinc(t) - sum), tail->at(0, magnitude::of(1, -2)).exact()));
    }
}

// Derivatives of the remainder: from one term on their bound decreases only if the distance is not too near the radius.
TEST_CASE("a series about a singular start holds values and slopes in its disc", "[ode][proved][singular]") {
    const precision_scope scope(60);
    for (const int degree : {11, 41, 201}) {
        INFO(degree);
        const singular_series series(lane_emden("5"), 150, degree);
        CHECK(certainly_less(series.radius().exact(), sqrt(ball(3))));
        for (const int part : {1, 4, 8}) {
            const ball s = exact_midpoint(series.radius().exact() * part / 10);
            const auto state = series.at(s);
            CHECK(overlaps(state[0], plummer(s)));
            CHECK(overlaps(state[1], -s / 3 * plummer(s) * plummer(s) * plummer(s)));
            const auto beside = series.at(complex_number<ball>(ball(0), s));  // at i s
            const ball exact = ball(1) / sqrt(ball(1) - s * s / 3);
            CHECK(overlaps(beside[0].re, exact));
            CHECK(overlaps(beside[1].im, -s / 3 * exact * exact * exact));
            CHECK(contains_zero(beside[0].im));
        }
        // Near the initial point the next power is all of the remainder.
        const ball s = exact_midpoint(series.radius().exact() / 64);
        const auto state = series.at(s);
        CHECK(overlaps(state[0], plummer(s)));
        CHECK(overlaps(state[1], -s / 3 * plummer(s) * plummer(s) * plummer(s)));
        CHECK_THROWS_AS(series.at(exact_midpoint(series.radius().exact() * 999 / 1000)), precision_exhausted);
    }
}

TEST_CASE("solutions from singular starts have proved digits", "[ode][proved][singular]") {
    const precision_scope scope(60);
    const auto states = proved_trajectory(lane_emden("5"), {typed("1/100"), typed("3"), typed("10")}, 30);
    const auto holds = [](const proved_decimal& found, const ball& exact) {
        return certainly_less(abs(ball(mpfr(found.text)) - exact), abs(exact) * pow(ball(10), -29));
    };
    const auto start = proved_trajectory(lane_emden("5"), {typed("0"), typed("1")}, 20);
    CHECK(start[0][0].text.substr(0, 3) == "1.0");
    CHECK(start[0][1].text == "0");
    CHECK_THROWS_WITH(proved_trajectory(lane_emden("5"), {typed("-1")}, 20),
                      Catch::Contains("before the initial point"));
    CHECK(holds(states[0][0], plummer(ball(1) / 100)));
    CHECK(holds(states[1][0], plummer(ball(3))));
    CHECK(holds(states[2][0], plummer(ball(10))));
}

// The first zero for n = 1 is pi; those of n = 2, 3, 4 are printed [Boyd2011] with 20 digits, the last of which is
// questioned by other sources.
TEST_CASE("the first zeros of Lane-Emden functions", "[ode][proved][singular]") {
    const auto zero = [](const std::string& n, long digits) {
        event_request request;
        request.g = parse_condition(equations(n), "y = 0");
        return proved_events(lane_emden(n), request, digits).front().time.text;
    };
    CHECK(zero("1", 20) == "3.1415926535897932385");
    CHECK(zero("3", 20).substr(0, 19) == "6.89684861937696037");
}

// With y(t) a solution for n = 5, c y(c^2 t) is another, with the initial value c: dy/dc = y + 2 t y' at c = 1. For n =
// 1 the equation is linear, and the condition number 1. Three digits of these numbers are proved.
TEST_CASE("condition numbers from singular starts", "[ode][proved][singular]") {
    const precision_scope scope(40);
    const auto conditions = [](const std::string& n, const std::string& time) {
        return proved_conditions(equations(n), {typed(time)}, 20).front();
    };
    for (const std::string time : {"1/100", "1", "10"}) {
        INFO(time);
        const ball t = constant_value<ball>::of(typed(time));
        const ball y = plummer(t);
        const ball slope = -t / 3 * y * y * y;
        const auto close = [](const mpfr& found, const ball& exact) {
            return certainly_less(abs(ball(found) - abs(exact)), abs(exact) / 1'000);
        };
        const auto of_plummer = conditions("5", time);
        CHECK(close(of_plummer.moved[0].by_start, y + t * slope * 2));
        CHECK(close(of_plummer.moved[0].by_time, t * slope));
        CHECK(of_plummer.moved[0].by_parameters == 0);
        const auto of_sinc = conditions("1", time);
        CHECK(close(of_sinc.moved[0].by_start, sinc(t)));
    }
    // y = p sin(q t)/(q t): an initial value and a frequency as parameters.
    const auto opened =
        proved_conditions(parse("t*y'' + 2*y' + q^2*t*y = 0; y(0) = p; y'(0) = 0; p = 3; q = 2"), {typed("1")}, 20);
    const ball by_p = sin(ball(2)) / 2 * 3;
    const ball by_q = (cos(ball(2)) / 2 - sin(ball(2)) / 4) * 3 * 2;
    CHECK(certainly_less(abs(ball(opened.front().moved[0].by_start) - abs(by_p)), abs(by_p) / 1'000));
    const ball both = abs(by_p) + abs(by_q);
    CHECK(certainly_less(abs(ball(opened.front().moved[0].by_parameters) - both), both / 1'000));
    // There is no value at the initial point itself, nor if the equation fixes a nonzero initial value.
    CHECK_THROWS_AS(conditions("5", "0"), error);
    CHECK_THROWS_AS(proved_conditions(parse("t*y' = 2 - y; y(0) = 2"), {typed("1")}, 10), error);
}

TEST_CASE("what theorem S does not take is refused", "[ode][proved][singular]") {
    const auto refused = [](const std::string& text) {
        CHECK_THROWS_AS(proved_singular_step(explicit_system(parse(text)), 100), error);
    };
    refused(std::string(problem_text("thomas_fermi")));
    refused("t*y'' + 2*y' + t*tan(y) = 0; y(0) = 1; y'(0) = 0");
    const precision_scope scope(30);
}

}  // namespace integration_singular_step_test
