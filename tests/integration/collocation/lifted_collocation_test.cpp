// Collocation with the added unknowns of polynomial forms: stiff equations with elementary functions and closed forms,
// sets of given unknowns as sets of all, and the steps that are reported.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/collocation/collocation_integrator.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_collocation_lifted_collocation_test {

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

// y_k = cos t + exp(-1e5 k t): seven unknowns with those of cos t, whose tubes are bounded by their values at nodes.
TEST_CASE("many stiff equations are proved by values at nodes", "[ode][proved]") {
    const precision_scope scope(80);
    std::string equations;
    std::string starts;
    for (const char* k : {"1", "2", "3", "4", "5"}) {
        equations += "y" + std::string(k) + "' = -1e5*" + k + "*(y" + k + " - cos(t)) - sin(t); ";
        starts += "; y" + std::string(k) + "(0) = 2";
    }
    proved_march march(system_of(equations.substr(0, equations.size() - 2) + starts), bits);
    const auto state = march.at(number(rational(1)));
    REQUIRE(state);
    REQUIRE(state->size() == 5);
    for (const ball& each : *state) {
        CHECK(encloses(each, cos(ball(1))));
    }
    CHECK(march.collocation().steps > 0);
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

// u = 1/(1 + t), from lengths that are too short and much too long; no length of 2^-60 of 1e30 ends before the pole of
// 1/(1 - t).
TEST_CASE("a step of collocation has a length with which it is proved", "[ode][proved]") {
    const precision_scope scope(80);
    const tube_set start{{{ball(1)}, lohner_set({}, {}, {}, {magnitude()})}, 0};
    collocation_integrator decay(lifted(system_of("u' = -u^2; u(0) = 1")), bits);
    for (const char* length : {"1/1024", "1000"}) {
        CAPTURE(length);
        decay.begin(ball(0), start, ball_of(length));
        REQUIRE(decay.prepare());
        CHECK(decay.prepare());
        const ball half = decay.length() / 2;
        CHECK(certainly_less(ball(0), half));
        CHECK(encloses(decay.values_at(half).front(), ball(1) / (ball(1) + half)));
    }
    collocation_integrator growth(lifted(system_of("u' = u^2; u(0) = 1")), bits);
    growth.begin(ball(0), start, ball_of("1e30"));
    CHECK_FALSE(growth.prepare());
}

// y = exp(-t), z = 1 - exp(-t), over 32 times the length: y is reduced by 3 percent, and to 1e-14; y = 1 - t to 2^-30.
TEST_CASE("a solution is smooth if no unknown decays and all numbers are those of long double", "[ode][proved]") {
    const precision_scope scope(80);
    const collocation_integrator by(lifted(system_of("y' = -y; z' = y; y(0) = 1; z(0) = 0")), bits);
    const auto smooth = [&](const ball& y, const ball& z, const ball& length) {
        return by.is_smooth_over(ball(0), {y, z}, length);
    };
    const ball huge = ldexp(ball(1), 20'000);
    const ball tiny = ldexp(ball(1), -20'000);
    const ball part = ldexp(ball(1), -10);
    CHECK(smooth(ball(1), ball(0), part));
    CHECK_FALSE(smooth(ball(1), ball(0), ball(1)));
    CHECK_FALSE(smooth(ball(1), tiny, part));
    CHECK_FALSE(smooth(ball(1), huge, part));
    CHECK_FALSE(smooth(ball(1), ball(0), huge));
    CHECK_FALSE(smooth(ball(1), ball(0), tiny));
    const collocation_integrator line(lifted(system_of("y' = -z; z' = 0; y(0) = 1; z(0) = 1")), bits);
    CHECK(line.is_smooth_over(ball(0), {ball(1), ball(1)}, ball(1) / 64));
    CHECK_FALSE(line.is_smooth_over(ball(0), {ball(1), ball(1)}, (ball(1) - ldexp(ball(1), -30)) / 32));
}

// The state at the beginning of the present step ends the collocation, which has proved it.
TEST_CASE("values are asked for where a step of collocation begins", "[ode][proved]") {
    const precision_scope scope(80);
    proved_march march(system_of("y' = -1e6*(y - cos(t)) - sin(t); y(0) = 2"), bits);
    REQUIRE(march.at(number(rational(10))));
    REQUIRE(march.collocation().steps > 0);
    const ball time = march.reached();
    const auto state = march.at(time);
    REQUIRE(state);
    CHECK(encloses(state->front(), cos(time)));
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
    for (int i = 1; i <= 251; ++i) {
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
    CHECK(refusal(many, 200, false).find("251") != std::string::npos);
    CHECK(refusal("y' = -y; y(0) = 1", 2000, false).find("2000") != std::string::npos);
    CHECK(refusal("y' = -y; y(0) = 1", 200, true).empty());
    CHECK(refusal(many.substr(0, many.find("y51'")), 500, false).find("500") != std::string::npos);
    CHECK(refusal(many.substr(0, many.find("y8'")), 200, false).empty());
    CHECK(refusal(many.substr(0, many.find("y8'")), 200, true).find("derivative") != std::string::npos);
}

}  // namespace integration_collocation_lifted_collocation_test
