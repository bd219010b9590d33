// Linear systems with constant coefficients by the exponential of their matrix, against closed forms and Taylor series.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/ode/parse.hpp"
#include "libration/ode/proved/linear_flow.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace ode_proved_linear_flow_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 200;

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

ball ball_of(const std::string& text) { return constant_value<ball>::of(parse_constant(text).constant()); }

bool encloses(const ball& found, const ball& truth) {
    return contains_zero(found - truth) && arb_rel_accuracy_bits(found.handle()) >= bits;
}

}  // namespace

TEST_CASE("the matrix exponential has the closed forms of oscillations, decays and constants", "[ode][proved]") {
    const precision_scope scope(80);
    const number time = parse_constant("7/3 + pi").constant();
    const ball t = constant_value<ball>::of(time) - 1L;
    const auto damped = linear_flow::of(system_of("x'' = -4*(x - 1/3); x(1) = 4/3; x'(1) = 0; y' = -1e5*y; y(1) = pi"));
    REQUIRE(damped);
    const auto state = damped->at(time, bits);
    REQUIRE(state);
    REQUIRE(state->size() == 3);
    CHECK(encloses((*state)[0], cos(t * 2L) + ball(1) / 3L));
    CHECK(encloses((*state)[1], sin(t * 2L) * -2L));
    CHECK(contains_zero((*state)[2] - exp(t * -100'000L) * pi<ball>()));
    // A nilpotent matrix and a constant: y = t^2/2.
    const auto parabola = linear_flow::of(system_of("y'' = 1; y(1) = 0; y'(1) = 0"))->at(time, bits);
    REQUIRE(parabola);
    CHECK(encloses((*parabola)[0], t * t / 2L));
}

TEST_CASE("other equations are not taken for linear ones with constant coefficients", "[ode][proved]") {
    for (const char* text : {"y' = y^2; y(0) = 1", "y' = t*y; y(0) = 1", "y' = -y + t; y(0) = 1",
                             "y' = sin(y); y(0) = 1", "y' = 1/y; y(0) = 1",
                             "y' = (1 + y)/(1 - y/2)^2 + log(y); y(0) = 1", "x' = y; y' = x*y; x(0) = 1; y(0) = 1"}) {
        CAPTURE(text);
        CHECK(!linear_flow::of(system_of(text)));
    }
}

// x - y = 0 at all times, which balls do not show.
TEST_CASE("an unknown that is 0 without a reason in balls is left to other integrators", "[ode][proved]") {
    const auto flow = linear_flow::of(system_of("x' = -x/3; y' = -x/3; x(0) = 1; y(0) = 1; z' = x - y; z(0) = 0"));
    REQUIRE(flow);
    CHECK(!flow->at(number(rational(1)), bits));
}

TEST_CASE("oscillations have values at any time, and growth as long as its size can be printed", "[ode][proved]") {
    const precision_scope scope(80);
    const number far = parse_constant("1e30").constant();
    const auto oscillation = linear_flow::of(system_of("y'' = -y; y(0) = 1; y'(0) = 0"))->at(far, bits);
    REQUIRE(oscillation);
    const precision_scope more(160);
    CHECK(encloses((*oscillation)[0], cos(constant_value<ball>::of(far))));
    const auto growth = linear_flow::of(system_of("y' = y; y(0) = 1"));
    CHECK(growth->at(parse_constant("1e6").constant(), bits));
    CHECK(!growth->at(far, bits));
}

TEST_CASE("both routes agree on linear problems of the DETEST sets", "[ode][proved]") {
    for (const char* name : {"detest_c1", "stiff_b5"}) {
        CAPTURE(name);
        const explicit_system system = system_of(std::string(problem_text(name)));
        const std::vector<number> times{number(rational(1, 2))};
        std::vector<step_method> methods;
        const auto by_exponential = proved_part_of_trajectory(
            system, times, 20, {}, {}, [&](const step_report& step) { methods.push_back(step.method); });
        const auto by_steps = proved_part_of_trajectory(system, times, 25, {}, proof_route::second());
        REQUIRE(!methods.empty());
        CHECK(methods.front() == step_method::exponential);
        REQUIRE(by_exponential.states.front().size() == by_steps.states.front().size());
        for (std::size_t i = 0; i < by_steps.states.front().size(); ++i) {
            REQUIRE(by_exponential.states.front()[i].decimal);
            REQUIRE(by_steps.states.front()[i].decimal);
            const ball a = ball_of(by_exponential.states.front()[i].decimal->text);
            const ball b = ball_of(by_steps.states.front()[i].decimal->text);
            CHECK(certainly_less(abs(a - b), abs(b) * pow(ball(10), -18L)));
        }
    }
}

}  // namespace ode_proved_linear_flow_test
