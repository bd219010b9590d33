// Stiff equations over many time scales, by collocation with tubes of theorem K: closed forms, a conservation law, the
// integrator of Taylor series, and starts that are balls.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/growth.hpp"
#include "libration/integration/collocation/tube_proof.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_collocation_stiff_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 200;

// u = 1/(1/u(0) + t), and v tends to u^2 like exp(-1e8 t).
const std::string closed = "u' = -u^2; v' = -1e8*(v - u^2) - 2*u^3; u(0) = 1; v(0) = ";

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

ball ball_of(const std::string& text) { return constant_value<ball>::of(parse_constant(text).constant()); }

// Whether the ball contains the number, and is narrower than 10^-digits of it.
bool encloses(const ball& found, const ball& truth, long digits) {
    const ball most = abs(truth) * pow(ball(10), -digits);
    return contains_zero(found - truth) && certainly_less(radius_of(found), most);
}

}  // namespace

TEST_CASE("a stiff solution with a closed form is followed over ten orders of time", "[ode][proved]") {
    const precision_scope scope(80);
    for (const char* start : {"1", "2", "1 + 1e-30"}) {
        CAPTURE(start);
        const explicit_system system = system_of(closed + start);
        proved_march march(system, bits);
        for (const char* time : {"1/3", "1e3", "1e10"}) {
            const auto state = march.at(parse_constant(time).constant());
            REQUIRE(state);
            const ball u = ball(1) / (ball(1) + ball_of(time));
            CHECK(encloses((*state)[0], u, 30));
            CHECK(encloses((*state)[1], u * u, 30));
        }
        CHECK(march.collocation().steps > 0);
        CHECK(march.steps() < 20'000);
    }
}

// x = exp(-t), y = x + (y(0) - 1) exp(-1e6 t), backwards in time as well: t = -s.
TEST_CASE("a linear stiff system has its closed form in both directions of time", "[ode][proved]") {
    const precision_scope scope(80);
    for (const int direction : {1, -1}) {
        const std::string sign = direction > 0 ? "" : "-1*";
        const explicit_system system =
            system_of("x' = " + sign + "(-x); y' = " + sign + "(-1e6*(y - x) - x); x(0) = 1; y(0) = 3");
        proved_march march(system, bits);
        const auto state = march.at(number(rational(5 * direction)));
        REQUIRE(state);
        const ball x = exp(ball(-5));
        CHECK(encloses((*state)[0], x, 30));
        CHECK(encloses((*state)[1], x, 30));
        CHECK(march.collocation().steps > 0);
    }
}

// u = c/(1 + c t) from u(0) = c, v tends to u^2: du/dc = (u/c)^2, dv/dc = 2 u du/dc up to exp(-1e8 t).
TEST_CASE("the derivative of a stiff flow is that of the closed form", "[ode][proved]") {
    const precision_scope scope(60);
    proof_route route;
    route.integrator = integrator_choice::collocation;
    proved_march march(system_of(closed + "2"), 100, {}, proved_march::usual_error_bits, route);
    march.keep_derivative();
    for (const char* time : {"1/1000", "1000"}) {
        const ball t = ball_of(time);
        REQUIRE(march.at(t));
        const ball u = ball(1) / (ball(1) + t);
        const auto flow = march.derivative_at(t);
        CHECK(encloses(flow[0][0], u * u, 15));
        CHECK(encloses(flow[1][0], u * u * u * 2L, 15));
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(contains_zero(flow[i][1]));
            CHECK(certainly_less(radius_of(flow[i][1]), pow(ball(10), -15L)));
        }
    }
    CHECK(march.collocation().steps < 100);
}

// x + y + z = 1 at all times; the sum of three enclosures that do not refer to it contains 1.
TEST_CASE("Robertson's equations keep their sum to 1e11 and agree with Taylor series at the beginning",
          "[ode][proved]") {
    const precision_scope scope(80);
    const explicit_system robertson = system_of(std::string(problem_text("robertson")));
    proved_march march(robertson, bits);
    for (const char* time : {"1/10", "40", "1e11"}) {
        const auto state = march.at(parse_constant(time).constant());
        REQUIRE(state);
        const ball sum = (*state)[0] + (*state)[1] + (*state)[2];
        CHECK(encloses(sum, ball(1), 40));
        if (time == std::string("1/10")) {
            proof_route taylor;
            taylor.integrator = integrator_choice::taylor;
            proved_march other(robertson, bits, {}, proved_march::usual_error_bits, taylor);
            proof_route collocation;
            collocation.integrator = integrator_choice::collocation;
            proved_march third(robertson, bits, {}, proved_march::usual_error_bits, collocation);
            const auto by_taylor = other.at(parse_constant(time).constant());
            const auto by_collocation = third.at(parse_constant(time).constant());
            REQUIRE(by_taylor);
            REQUIRE(by_collocation);
            CHECK(other.collocation().steps == 0);
            CHECK(third.collocation().steps > 0);
            for (std::size_t i = 0; i < 3; ++i) {
                CHECK(contains_zero((*by_taylor)[i] - (*by_collocation)[i]));
                CHECK(encloses((*by_collocation)[i], (*by_taylor)[i], 30));
            }
        }
    }
}

// What a set of starts becomes contains what becomes of its points, also of those at its border.
TEST_CASE("the tube of starts that are balls contains the solutions from shifted starts", "[ode][proved]") {
    const precision_scope scope(80);
    const ball width = pow(ball(10), -20L);
    const std::vector<ball> start{enclose(ball(1), width), enclose(ball(1), width)};
    proof_route route;
    route.integrator = integrator_choice::collocation;
    for (const char* time : {"1e-3", "1", "1e4"}) {
        CAPTURE(time);
        proved_march march(system_of(closed + "1"), start, bits, proved_march::usual_error_bits, {}, route);
        const auto state = march.at(parse_constant(time).constant());
        REQUIRE(state);
        for (const int side : {-1, 1}) {
            const ball shifted = ball(1) + width * ball(15 * side) / ball(16);
            const ball u = shifted / (ball(1) + shifted * ball_of(time));
            CHECK(arb_contains((*state)[0].handle(), u.handle()) != 0);
            CHECK(certainly_less(radius_of((*state)[0]), width * ball(4)));
        }
    }
}

// r' = r grows like exp(t): from 1 to 2.2 in one unit of time is enough at its beginning and not at its end.
TEST_CASE("affine radii have to grow fast enough at both ends", "[ode][proved]") {
    const precision_scope scope(30);
    comparison_system system;
    system.diagonal = {ball(1)};
    system.beside = {magnitude()};
    system.defect = {magnitude()};
    const auto radii = [](unsigned long first_tenths, unsigned long last_tenths) {
        return affine_radii{{magnitude(first_tenths) / 10U}, {magnitude(last_tenths) / 10U}};
    };
    CHECK_FALSE(satisfies(system, radii(10, 22), 1));
    CHECK_FALSE(satisfies(system, radii(10, 15), 1));
    system.diagonal = {ball(1) / 2L};
    CHECK(satisfies(system, radii(10, 22), 1));
    system.diagonal = {ball(-1)};
    CHECK_FALSE(
        satisfies(system, radii(22, 10), 1));  // it decays to 0.81, but at its end only like 1 in a unit of time
    CHECK(satisfies(system, radii(22, 22), 1));
    const auto found = affine_growth(system, {magnitude(1U)}, 1);
    REQUIRE(found);
    CHECK(satisfies(system, *found, 1));
}

// s = t/mu, mu = 100: x'' = mu (1 - x^2) x' - x becomes d^2x/ds^2 = mu^2 ((1 - x^2) dx/ds - x).
TEST_CASE("a relaxation oscillation is followed over several jumps in both scalings of time", "[ode][proved]") {
    const precision_scope scope(80);
    const explicit_system by_s = system_of("y' = z; z' = 1e4*((1 - y^2)*z - y); y(0) = 2; z(0) = -0.66");
    const explicit_system by_t = system_of("x'' = 100*(1 - x^2)*x' - x; x(0) = 2; x'(0) = -0.0066");
    proved_march first(by_s, 150);
    proved_march second(by_t, 180);
    const auto a = first.at(number(rational(4)));
    const auto b = second.at(number(rational(400)));
    REQUIRE(a);
    REQUIRE(b);
    CHECK(contains_zero((*a)[0] - (*b)[0]));
    CHECK(encloses((*a)[0], (*b)[0], 25));
    CHECK(contains_zero((*a)[1] - (*b)[1] * 100L));
    // Collocation begins again soon after each jump.
    CHECK(first.collocation().periods >= 4);
    CHECK(first.steps() < 3'000);
}

// The tube around the solution of a neighbouring equation: its defect has a constant sign, so that the radii cannot be
// smaller than the distance of both solutions. The curves x = (1 + e) t and y = e/1024 solve the equations with e added
// to both; at t = 1 they are e and e/1024 away from x = t and y = 0, by growth and by the balance of defect and decay.
TEST_CASE("the bound of a defect of constant sign is sharp", "[ode][proved]") {
    const precision_scope scope(60);
    const auto form = lifted(explicit_system(parse("x' = 1; y' = -1024*y; x(0) = 0; y(0) = 0")));
    const polynomial_map map(form);
    const ball e = pow(ball(2), -60L);
    const ball half = (ball(1) + e) * pow(ball(2), -1L);
    const std::vector<ball_polynomial> unit{{ball(1)}, {}, {}, {ball(1)}};
    const tube_candidate neighbour{
        {ball(0), ball(1)}, {0, 0}, {{half, half}, {e * pow(ball(2), -10L)}}, {unit, unit, {1, 1}, 1}};
    const tube_set start{{{ball(0), ball(0)}, lohner_set({}, {}, {}, {magnitude(), magnitude()})}, 0};
    for (const auto by : {supremum_rule::coefficients, supremum_rule::nodes}) {
        const auto tube = tube_proof(map, 200, 200, 200).tube(neighbour, start, by);
        REQUIRE(tube);
        const auto last = tube->values_at(ball(1));
        CHECK(arb_contains_si(last[0].handle(), 1) != 0);
        CHECK(contains_zero(last[1]));
        // Bounds are rounded up in every operation, to 30 bits.
        CHECK(certainly_less(radius_of(last[0]) * ball(9), e * ball(10)));
        CHECK(certainly_less(radius_of(last[1]) * ball(9), e * pow(ball(2), -10L) * ball(10)));
    }
}

// The same distances in a frame V = 1 with W = 7/8 for its inverse: |W V - 1| = 1/8. By a defect, x' = 1 + e for x' = 1,
// and by a start that is e away from the curve x = t.
TEST_CASE("an inverse of a frame that is only approximate is corrected", "[ode][proved]") {
    const precision_scope scope(60);
    const polynomial_map map(lifted(explicit_system(parse("x' = 1; x(0) = 0"))));
    const ball e = pow(ball(2), -60L);
    const ball half = pow(ball(2), -1L);
    const moving_frame frame{{{ball(1)}}, {{ball(7) * pow(ball(2), -3L)}}, {1}, 1};
    const auto set_at = [](const ball& x) { return tube_set{{{x}, lohner_set({}, {}, {}, {magnitude()})}, 0}; };
    const auto at_end = [&](const ball& slope, const ball& start) {
        const ball part = slope * half;  // of 1 + x, -1 <= x <= 1
        const tube_candidate candidate{{ball(0), ball(1)}, {0}, {{part, part}}, frame};
        std::vector<ball> ends;
        for (const auto by : {supremum_rule::coefficients, supremum_rule::nodes}) {
            const auto tube = tube_proof(map, 200, 200, 200).tube(candidate, set_at(start), by);
            REQUIRE(tube);
            ends.push_back(tube->values_at(ball(1))[0]);
        }
        return ends;
    };
    for (const ball& end : at_end(ball(1) + e, ball(0))) {
        CHECK(arb_contains_si(end.handle(), 1) != 0);
        CHECK(certainly_less(radius_of(end), e * ball(2)));
    }
    for (const ball& end : at_end(ball(1), e)) {
        CHECK(contains_zero(end - ball(1) - e));
        CHECK(certainly_less(radius_of(end), e * ball(2)));
    }
}

// V = 1, and W = (1 + 1) 1/2 by a change: from a start that is e away from the curve x = t, solutions stay e away from it.
TEST_CASE("the change of an inverse enters the radii at the start", "[ode][proved]") {
    const precision_scope scope(60);
    const polynomial_map map(lifted(explicit_system(parse("x' = 1; x(0) = 0"))));
    const ball e = pow(ball(2), -60L);
    const ball half = pow(ball(2), -1L);
    const tube_candidate candidate{
        {ball(0), ball(1)}, {0}, {{half, half}}, {{{ball(1)}}, {{half}}, {1}, 1, {{ball(1)}}}};
    const tube_set start{{{e}, lohner_set({}, {}, {}, {magnitude()})}, 0};
    const auto tube = tube_proof(map, 200, 200, 200).tube(candidate, start, supremum_rule::nodes);
    REQUIRE(tube);
    const ball end = tube->values_at(ball(1))[0];
    CHECK(contains_zero(end - ball(1) - e));
    CHECK(certainly_less(radius_of(end), e * ball(2)));
}

TEST_CASE("collocation is left alone where it is of no use", "[ode][proved]") {
    for (const char* text : {"y' = -y; y(0) = 1", "y' = y; y(0) = 1", "x' = y; y' = -x; x(0) = 1; y(0) = 0",
                             "x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y-8/3*z; x(0)=1; y(0)=1; z(0)=1"}) {
        CAPTURE(text);
        proved_march march(system_of(text), bits);
        REQUIRE(march.at(number(rational(20))));
        CHECK(march.collocation().steps == 0);
    }
}

}  // namespace integration_collocation_stiff_test
