// Linear systems with constant coefficients by the exponential of their matrix, against closed forms and Taylor series.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/closed_form/linear_flow.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_closed_form_linear_flow_test {

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

namespace {

std::string named(const char* name, int i) { return name + std::to_string(i); }

// x1' = rate x1, x2' = rate x2, ..: as many unknowns and so few entries that the series of the vector is used.
std::string independent_unknowns(int count, const std::string& rate) {
    std::string text;
    for (int i = 1; i <= count; ++i) {
        const std::string x = named("x", i);
        text += x + "' = (" + rate + ")*" + x + "; " + x + "(0) = " + std::to_string(i) + "; ";
    }
    return text;
}

// u_i' = u_(i-1) - 2 u_i + u_(i+1), u_0 = u_(n+1) = 0, u_m(0) = 1 alone: u_i(t) = 2/(n + 1) sum_k sin(i k p) sin(m k p)
// exp(-4 sin(k p/2)^2 t), p = pi/(n + 1).
std::string diffusion(int count, int middle) {
    std::string text;
    for (int i = 1; i <= count; ++i) {
        const std::string u = named("u", i);
        text += u + "' = " + (i > 1 ? named("u", i - 1) : "0") + " - 2*" + u +
                (i < count ? " + " + named("u", i + 1) : "") + "; " + u + "(0) = " + (i == middle ? "1" : "0") + "; ";
    }
    return text;
}

ball diffused(int count, int middle, int i, const ball& t) {
    const ball unit = pi<ball>() / static_cast<long>(count + 1);
    ball sum(0);
    for (long k = 1; k <= count; ++k) {
        const ball half = sin(unit * k / 2L);
        sum += sin(unit * k * static_cast<long>(i)) * sin(unit * k * static_cast<long>(middle)) *
               exp(half * half * t * -4L);
    }
    return sum * 2L / static_cast<long>(count + 1);
}

}  // namespace

// The rest of the series is between 1/40 of the last bit and all of it, depending on the number of bits.
TEST_CASE("the series of a vector encloses exponentials at any number of bits", "[ode][proved]") {
    for (const char* rate : {"1/3", "-2", "7", "-7/2", "1 - 2^(-349)", "2^(-100) - 1"}) {
        const auto flow = linear_flow::of(system_of(independent_unknowns(25, rate)));
        REQUIRE(flow);
        for (long some = 90; some < 120; ++some) {
            CAPTURE(rate, some);
            const auto state = flow->at(number(rational(3, 2)), some);
            REQUIRE(state);
            const precision_scope scope(100);
            const ball factor = exp(ball_of(rate) * 3L / 2L);
            for (std::size_t i = 0; i < state->size(); ++i) {
                CHECK(contains_zero((*state)[i] - factor * static_cast<long>(i + 1)));
                CHECK(arb_rel_accuracy_bits((*state)[i].handle()) >= some);
            }
        }
    }
}

TEST_CASE("the series of a vector has the closed form of diffusion along a chain", "[ode][proved]") {
    const int count = 40;
    const int middle = 7;
    const auto flow = linear_flow::of(system_of(diffusion(count, middle)));
    REQUIRE(flow);
    const precision_scope scope(100);
    for (const long t : {0L, 3L, 20L, -2L}) {
        const auto state = flow->at(number(rational(t)), bits);
        CAPTURE(t);
        REQUIRE(state);
        for (int i = 1; i <= count; ++i) {
            const ball& found = (*state)[static_cast<std::size_t>(i - 1)];
            CHECK(contains_zero(found - diffused(count, middle, i, ball(t))));
            CHECK((t == 0 || arb_rel_accuracy_bits(found.handle()) >= bits));
        }
    }
}

// x1' = 1, x_(i+1)' = x_i: t^i/i!, and what is not reached remains exactly 0 or constant.
TEST_CASE("the series of a vector ends where its terms do, and leaves constants exact", "[ode][proved]") {
    std::string text = "x1' = 1; x1(0) = 0; rest' = a*x1; rest(0) = 0; other' = rest; other(0) = 5; a = 0; ";
    for (int i = 2; i <= 25; ++i) {
        const std::string x = named("x", i);
        text += x + "' = " + named("x", i - 1) + "; " + x + "(0) = 0; ";
    }
    const auto flow = linear_flow::of(system_of(text));
    REQUIRE(flow);
    const auto state = flow->at(number(rational(3)), bits);
    REQUIRE(state);
    const precision_scope scope(100);
    ball expected(1);
    CHECK(arb_equal_si((*state)[0].handle(), 3) != 0);
    CHECK(arb_is_zero((*state)[1].handle()) != 0);
    CHECK(arb_equal_si((*state)[2].handle(), 5) != 0);
    for (std::size_t i = 1; i <= 25; ++i) {
        expected = expected * 3L / static_cast<long>(i);
        CHECK(encloses((*state)[i == 1 ? 0 : i + 1], expected));
    }
}

// x1' = -r x1, x_(i+1)' = r (x_i - x_(i+1)): (r t)^i/i! exp(-r t), 1e-88 for the last one, and the sum of all with an inflow.
TEST_CASE("a chain of conversions has all bits of its smallest unknowns", "[ode][proved]") {
    const int count = 60;
    const long rate = 40;
    std::string text =
        "x0' = -40*x0; x0(0) = 1; whole' = 40*x0; whole(0) = 0; flown' = 7 - 40*flown; flown(0) = 1; kept' = 0; "
        "kept(0) = 3; ";
    for (int i = 1; i < count; ++i) {
        text += named("x", i) + "' = 40*" + named("x", i - 1) + " - 40*" + named("x", i) + "; " + named("x", i) +
                "(0) = 0; ";
    }
    const auto flow = linear_flow::of(system_of(text));
    REQUIRE(flow);
    const precision_scope scope(100);
    for (const rational& time : {rational(1, 50), rational(1), rational(3)}) {
        const auto state = flow->at(number(time), bits);
        REQUIRE(state);
        const ball gone = constant_value<ball>::of(number(time)) * rate;
        ball expected = exp(-gone);
        CHECK(encloses((*state)[1], ball(1) - expected));
        CHECK(encloses((*state)[2], expected + (ball(1) - expected) * 7L / rate));
        CHECK(arb_equal_si((*state)[3].handle(), 3) != 0);
        for (int i = 0; i < count; ++i) {
            CHECK(encloses((*state)[i == 0 ? 0 : static_cast<std::size_t>(i) + 3], expected));
            expected = expected * gone / static_cast<long>(i + 1);
        }
    }
    const auto before = flow->at(number(rational(-1, 50)), bits);
    REQUIRE(before);
    CHECK(encloses((*before)[0], exp(ball(rate) / 50L)));
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

}  // namespace integration_closed_form_linear_flow_test
