// Collocation with the added unknowns of polynomial forms: stiff equations with elementary functions and closed forms,
// sets of given unknowns as sets of all, and the steps that are reported.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace ode_proved_lifted_collocation_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 170;
constexpr long digits = 30;

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

ball ball_of(const std::string& text) { return constant_value<ball>::of(parse_constant(text).constant()); }

bool encloses(const ball& found, const ball& truth) {
    const ball most = abs(truth) * pow(ball(10), -digits);
    return contains_zero(found - truth) && certainly_less(radius_of(found), most);
}

struct closed_solution {
    std::string equations, truth;  ///< the truth at the time 10
};

}  // namespace

// Each solution is attracted within 1e-5 by a smooth one, y - truth decays like exp(-1e5 t) or faster.
TEST_CASE("stiff equations with elementary functions are proved by their polynomial form", "[ode][proved]") {
    const precision_scope scope(80);
    const std::vector<closed_solution> all{
        {"y' = -1e6*(y - cos(t)) - sin(t); y(0) = 2", "cos(10)"},
        {"y' = -1e6*(exp(y) - (1+t)) + 1/(1+t); y(0) = 1", "log(11)"},
        {"y' = 1e6*(1/y - (1+t)) - 1/(1+t)^2; y(0) = 2", "1/11"},
        {"y' = -1e5*(y - sqrt(1+t)) + 1/(2*sqrt(1+t)); y(0) = 3", "sqrt(11)"},
        {"y' = -1e6*(y - cos(t)) - sin(t); y(1/10) = 2", "cos(10)"},
    };
    for (const closed_solution& each : all) {
        CAPTURE(each.equations);
        proved_march march(system_of(each.equations), bits);
        const auto state = march.at(number(rational(10)));
        REQUIRE(state);
        CHECK(state->size() == 1);
        CHECK(encloses(state->front(), ball_of(each.truth)));
        CHECK(march.collocation().steps > 0);
        CHECK(march.collocation().steps < 60);
        CHECK(march.collocation().last == 10);
    }
}

// The solutions of y' = -k (y - cos t) - sin t from c + d differ from cos t by (c + d - 1) exp(-k t).
TEST_CASE("a start that is a ball contains the solutions from its points with added unknowns", "[ode][proved]") {
    const precision_scope scope(80);
    const ball width = pow(ball(10), -20L);
    proof_route route;
    route.integrator = integrator_choice::collocation;
    for (const char* time : {"1", "5/2"}) {
        CAPTURE(time);
        proved_march march(system_of("y' = -20*(y - cos(t)) - sin(t); y(0) = 2"), {enclose(ball(2), width)}, bits,
                           proved_march::usual_error_bits, {}, route);
        const auto state = march.at(parse_constant(time).constant());
        REQUIRE(state);
        const ball decay = exp(ball_of(time) * ball(-20));
        for (const int side : {-1, 1}) {
            const ball start = ball(2) + width * ball(15 * side) / ball(16);
            const ball y = cos(ball_of(time)) + (start - ball(1)) * decay;
            CHECK(arb_contains(state->front().handle(), y.handle()) != 0);
        }
        CHECK(march.collocation().steps > 0);
    }
}

TEST_CASE("collocation is left alone where equations with functions are not stiff", "[ode][proved]") {
    for (const char* text : {"x'' = -sin(x); x(0) = 2; x'(0) = 0", "y' = -y + exp(-t); y(0) = 1"}) {
        CAPTURE(text);
        proved_march march(system_of(text), bits);
        REQUIRE(march.at(number(rational(20))));
        CHECK(march.collocation().steps == 0);
    }
}

// Steps from 1e-16 on grow with the time: at each of them, the rest of the way is 1000 steps of the same length and
// more.
TEST_CASE("a trial of collocation in vain does not take longer than the steps of Taylor series", "[ode][proved]") {
    const precision_scope scope(400);
    proved_march march(system_of("y' = 1/(32*y); y(0) = 2^(-27)"), 690);
    const auto state = march.at(number(rational(2, 5)));
    REQUIRE(state);
    CHECK(overlaps(state->front(), ball_of("sqrt(1/40 + 2^(-54))")));
    CHECK(march.collocation().steps == 0);
}

TEST_CASE("each step that is used is reported once, in order", "[ode][proved]") {
    const std::vector<number> times{number(rational(1)), number(rational(2)), number(rational(10))};
    std::vector<step_report> steps;
    const auto found = proved_part_of_trajectory(system_of("y' = -1e6*(y - cos(t)) - sin(t); y(0) = 2"), times, 20, {},
                                                 {}, [&](const step_report& step) { steps.push_back(step); });
    REQUIRE(!found.missing);
    REQUIRE(found.collocation.size() == 1);
    long by_collocation = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        by_collocation += steps[i].method == step_method::collocation ? 1 : 0;
        CHECK(steps[i].length > 0);
        if (i > 0) {
            CHECK(steps[i].time == Approx(steps[i - 1].time + steps[i - 1].length));
        }
    }
    CHECK(steps.front().time == 0);
    CHECK(steps.front().method == step_method::taylor);
    CHECK(steps.back().time + steps.back().length >= 10);
    CHECK(by_collocation == found.collocation.front().steps);
    CHECK(found.collocation.front().periods == 1);
}

TEST_CASE("collocation is refused where it is chosen and not possible", "[ode][proved]") {
    proof_route route;
    route.integrator = integrator_choice::collocation;
    std::string many;
    for (int i = 1; i <= 41; ++i) {
        const std::string name = "y" + std::to_string(i);
        many += name + "' = -" + name + " + y1; " + name + "(0) = 1; ";
    }
    const auto refusal = [&](const std::string& text, long with_bits, bool derivative) -> std::string {
        try {
            proved_march march(system_of(text), with_bits, {}, proved_march::usual_error_bits, route);
            if (derivative) {
                march.keep_derivative();
            }
        } catch (const error& problem) {
            CHECK(problem.kind() == error_kind::argument);
            CHECK(problem.subject() == "integrator");
            return problem.reason();
        }
        return "";
    };
    CHECK(refusal("y' = -y; y(0) = 1", 200, false).empty());
    CHECK(refusal(many, 200, false).find("41") != std::string::npos);
    CHECK(refusal("y' = -y; y(0) = 1", 2000, false).find("2000") != std::string::npos);
    CHECK(refusal("y' = -y; y(0) = 1", 200, true).find("derivative") != std::string::npos);
}

}  // namespace ode_proved_lifted_collocation_test
