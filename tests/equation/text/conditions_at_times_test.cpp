// Conditions between values at several times, parameters and free times, compared with closed forms; their messages.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"

namespace equation_text_conditions_at_times_test {

using namespace libration;
using namespace libration::ode;
using strings = std::vector<std::string>;

namespace {

constexpr long digits = 40;

std::vector<ball> found(const std::string& text, const strings& names, const strings& conditions) {
    const equation_system system = parse(text);
    conditions_at_times all;
    for (const std::string& each : conditions) {
        add_condition(all, system, each);
    }
    std::vector<ball> values;
    const precision_scope scope(digits + 30);
    for (const proved_decimal& each : proved_unknowns(system, names, all, digits)) {
        mpfr value;
        mpfr_set_str(handle(value), each.text.c_str(), 10, MPFR_RNDN);
        values.emplace_back(value);
    }
    return values;
}

bool equal(const ball& printed, const ball& exact) {
    return certainly_less(abs(printed - exact), abs(exact) * pow(ball(10), 1 - digits));
}

std::string message(const std::string& condition) {
    conditions_at_times all;
    try {
        add_condition(all, parse("y'' = -k*y; y(0) = 0; y'(0) = 1; k = 1"), condition);
    } catch (const error& problem) {
        return problem.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a condition that mixes an unknown and its derivative", "[ode][proved][conditions]") {
    const precision_scope scope(digits + 30);
    // y = s cos t + sin t.
    const auto robin = found("y'' = -y; y(0) = 1; y'(0) = 1", {"y(0)"}, {"y(1) + y'(1) = 0"});
    const ball c = cos(ball(1));
    const ball s = sin(ball(1));
    CHECK(equal(robin[0], (s + c) / (s - c)));
}

TEST_CASE("a condition between values at several times, on both sides of the start", "[ode][proved][conditions]") {
    const precision_scope scope(digits + 30);
    const auto product = found("y' = y; y(0) = 1", {"y(0)"}, {"y(-1)*y(1/2)^2*y(0) = 16"});
    CHECK(equal(product[0], ball(2)));
    // Periodic in y and antiperiodic in nothing: y = a cos t + b sin t + 1.
    const auto both =
        found("y'' = 1 - y; y(0) = a; y'(0) = b; a = 2; b = 1/2", {"a", "b"}, {"y(0) = y(1)", "y(0) + y'(0) = 3"});
    const ball ratio = sin(ball(1)) / (ball(1) - cos(ball(1)));  // a - 1 = ratio b
    CHECK(equal(both[1], ball(2) / (ratio + 1)));
    CHECK(equal(both[0], ball(1) + ratio * 2 / (ratio + 1)));
}

TEST_CASE("an integral as a condition, through an added unknown", "[ode][proved][conditions]") {
    const precision_scope scope(digits + 30);
    const auto norm = found("y' = y; w' = y^2; y(0) = 1; w(0) = 0", {"y(0)"}, {"w(1) = 1"});
    CHECK(equal(norm[0], sqrt(ball(2) / (exp(ball(2)) - 1))));
}

TEST_CASE("a condition with an unknown parameter, and with an unknown time", "[ode][proved][conditions]") {
    const precision_scope scope(digits + 30);
    // e^k = 3 k has two solutions; exp(k)/k = 3 decides which digits are right.
    const auto rate = found("y' = k*y; y(0) = 1; k = 1/2", {"k"}, {"y(1) = 3*k"});
    CHECK(certainly_less(abs(exp(rate[0]) / rate[0] - 3), pow(ball(10), 2 - digits)));
    const auto time = found("y'' = -y; y(0) = 1; y'(0) = 0; T = 2", {"T"}, {"y(T) = y'(T)"});
    CHECK(equal(time[0], pi<ball>() * 3 / 4));
    const auto shifted = found("y' = y; y(0) = 1; T = 1/2", {"T"}, {"y(2*T) - y(-T) = 0.5"});
    const ball e = exp(shifted[0]);
    CHECK(certainly_less(abs(e * e - ball(1) / e - ball(1) / 2), pow(ball(10), 3 - digits)));
}

// The half period of the pendulum with the energy -cos(pi/3) is 2 K(m = 1/4) = 2 pi/(2 agm(1, sqrt(3)/2)).
TEST_CASE("an orbit of a fixed energy, by its half period", "[ode][proved][conditions]") {
    const precision_scope scope(digits + 30);
    const auto orbit = found("x'' = -sin(x); x(0) = 1; x'(0) = 0; T = 4", {"x(0)", "T"},
                             {"x'(T) = 0", "x'(0)^2/2 - cos(x(0)) = -1/2"});
    ball a(1);
    ball b = sqrt(ball(3)) / 2;
    for (int i = 0; i < 10; ++i) {
        const ball mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    CHECK(equal(orbit[0], pi<ball>() / 3));
    CHECK(equal(orbit[1], pi<ball>() / a));
}

TEST_CASE("conditions that contain no value, or a derivative that is not part of the state",
          "[ode][proved][conditions][bad input]") {
    const std::string text = "y' = k*y; y(0) = 1; k = 1";
    CHECK_THROWS_WITH(found(text, {"k"}, {"k = 2"}), Catch::Contains("contain no value of an unknown"));
    CHECK_THROWS_WITH(found(text, {"k"}, {"y'(1) = 2"}), Catch::Contains("not part of the state"));
    CHECK_THROWS_WITH(found(text, {"q"}, {"y(1) = 2"}), Catch::Contains("choose one of them, k, y(0)"));
}

TEST_CASE("Newton's failures contain the last iterate and the residual", "[ode][proved][conditions]") {
    // y(1) = a^2 + 1: no real solution.
    CHECK_THROWS_WITH(found("y' = a^2 + 1; y(0) = 0; a = 3", {"a"}, {"y(1) = 0"}),
                      Catch::Contains("the last iterate is a = ") && Catch::Contains(", with residual "));
    CHECK_THROWS_WITH(found("y' = k*y^2; y(0) = 1; k = 3", {"k"}, {"y(1) = 2"}),
                      Catch::Contains("the last iterate is k = 3.000000000, where the conditions have no value"));
}

TEST_CASE("a condition that is not accepted is shown as it would be", "[ode][parse][conditions][bad input]") {
    CHECK_THAT(message("y(1) + y' = 0"), Catch::Contains("write y(1) + y'(1) = 0 with the time"));
    CHECK_THAT(message("y(1) + y'(t) = 0"), Catch::Contains("write y(1) + y'(1) = 0 with the time"));
    CHECK_THAT(message("y(1) = t"), Catch::Contains("write y(1) = 1 with the time"));
    CHECK_THAT(message("y(y(1)) = 2"), Catch::Contains("write y(1) = 2 with the time"));
    CHECK_THAT(message("y(1) + y'(1)"), Catch::Contains("write y(1) + y'(1) = 0"));
    CHECK_THAT(message("y(1) = 0; y(2) = 0"), Catch::Contains("the first as y(1) = 0"));
    CHECK_THAT(message("1 = 2"), Catch::Contains("contains neither"));
    CHECK_THAT(message(""), Catch::Contains("is not a condition"));
    CHECK_THAT(message("q(1) = 2"), Catch::Contains("'q'"));
    CHECK(message("2 y(1/2) = k").empty());
}

}  // namespace equation_text_conditions_at_times_test
