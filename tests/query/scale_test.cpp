// Each unknown has its digits relative to itself: closed forms at all sizes, mixed sizes in one system, units of
// measure, exact zeros, sparse series, and the remaining results if one value or time is undecided.
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace query_scale_test {

using namespace libration;
using namespace libration::ode;

namespace {

partial_trajectory part_of(const std::string& text, const std::vector<number>& times, long digits) {
    return proved_part_of_trajectory(explicit_system(parse(text)), times, digits);
}

std::vector<std::string> digits_at(const std::string& text, const rational& time, long digits) {
    std::vector<std::string> all;
    const auto states = proved_trajectory(explicit_system(parse(text)), {number(time)}, digits);
    for (const proved_decimal& each : states[0]) {
        all.push_back(each.text);
    }
    return all;
}

// Whether the error of the decimal is less than one unit of its last digit.
bool is_within_unit(const std::string& decimal, const ball& truth, long digits) {
    const ball printed = constant_value<ball>::of(parse_constant(decimal).constant());
    return certainly_less(abs(printed - truth), abs(truth) * pow(ball(10), 1 - digits));
}

// The decimals at a time compared with closed forms.
void check(const std::string& text, const rational& time, const std::vector<ball>& truths, long digits = 20) {
    CAPTURE(text);
    const auto found = digits_at(text, time, digits);
    REQUIRE(found.size() == truths.size());
    for (std::size_t i = 0; i < truths.size(); ++i) {
        CAPTURE(i, found[i], tests::text_of(truths[i]));
        CHECK(is_within_unit(found[i], truths[i], digits));
    }
}

ball power_of_ten(long n) { return pow(ball(10), n); }

}  // namespace

TEST_CASE("an exponential has its digits at any size", "[ode][proved]") {
    const precision_scope scope(60);
    for (const int direction : {1, -1}) {
        for (const char* start : {"1", "1e300", "1e-1000", "1e1000", "-1e1000"}) {
            for (const int time : {1, 400, 3000}) {
                const std::string text = std::string("y' = ") + (direction < 0 ? "-" : "") + "y; y(0) = " + start;
                const ball first = constant_value<ball>::of(parse_constant(start).constant());
                check(text, time, {first * exp(ball(time) * direction)});
            }
        }
    }
    check("y' = y; y(0) = 1", 10'000, {exp(ball(10'000))});
    check("y' = -y; y(0) = 1", 10'000, {exp(-ball(10'000))});
}

TEST_CASE("unknowns of one system have their own sizes", "[ode][proved]") {
    const precision_scope scope(60);
    const ball t(20);
    const ball slow = exp(-t);
    const ball fast = exp(t * -100);
    check("x' = -x + y; y' = -100*y; x(0) = 1; y(0) = 1", 20, {slow + (slow - fast) / 99, fast});
    check("y' = -100*y + z; z' = -90*z; y(0) = 1; z(0) = 1", 20, {fast + (exp(t * -90) - fast) / 10, exp(t * -90)});
    check("x' = x; y' = -100*y + 1e-900*x; x(0) = 1; y(0) = 1e-900", 2,
          {exp(ball(2)), (exp(ball(2)) / 101 + exp(ball(-200)) * 100 / 101) * power_of_ten(-900)});
    check("x' = x*y; y' = -y; x(0) = 1e-700; y(0) = 1", 30,
          {exp(ball(1) - exp(ball(-30))) * power_of_ten(-700), exp(ball(-30))});
    check("x'' = -x; y' = x'; z' = -50*z + 0*x; x(0) = 0; x'(0) = 1e-600; y(0) = 0; z(0) = 1", 10,
          {sin(ball(10)) * power_of_ten(-600), cos(ball(10)) * power_of_ten(-600), sin(ball(10)) * power_of_ten(-600),
           exp(ball(-500))});
}

// Problems A1 and B1 of the stiff set [EnrightHullLindberg1975].
TEST_CASE("stiff problems have digits of what has died out", "[ode][proved]") {
    const precision_scope scope(60);
    const ball t(20);
    check("y1' = -y1/2; y2' = -y2; y3' = -100*y3; y4' = -90*y4; y1(0) = 1; y2(0) = 1; y3(0) = 1; y4(0) = 1", 20,
          {exp(-t / 2), exp(-t), exp(t * -100), exp(t * -90)});
    check(
        "y1' = -y1 + y2; y2' = -100*y1 - y2; y3' = -100*y3 + y4; y4' = -10000*y3 - 100*y4; y1(0) = 1; y2(0) = 0; "
        "y3(0) = 1; y4(0) = 0",
        20,
        {exp(-t) * cos(t * 10), exp(-t) * sin(t * 10) * -10, exp(t * -100) * cos(t * 100),
         exp(t * -100) * sin(t * 100) * -100});
}

// y -> 2^k y and t -> 2^m t change only exponents.
TEST_CASE("units of measure do not change the proof", "[ode][proved]") {
    const precision_scope scope(100);
    const auto state = [](const std::string& text, const rational& time) {
        proved_march march(explicit_system(parse(text)), 150);
        auto values = march.at(number(time));
        REQUIRE(values.has_value());
        return *std::move(values);
    };
    const auto plain = state("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 1; z(0) = 3", 2);
    for (const long k : {-5000L, 4000L}) {
        const std::string a = "2^(" + std::to_string(k) + ")";
        const std::string b = "2^(" + std::to_string(-k) + ")";
        // x and y in units of 1/a, z in units of 1.
        const auto other = state("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y*(" + b + ")^2 - 8/3*z; x(0) = " + a +
                                     "; y(0) = " + a + "; z(0) = 3",
                                 2);
        for (std::size_t i = 0; i < 3; ++i) {
            const ball scaled = ldexp(other[i], i == 2 ? 0 : -k);
            CHECK(overlaps(scaled, plain[i]));
            CHECK(arb_rel_accuracy_bits(scaled.handle()) > arb_rel_accuracy_bits(plain[i].handle()) - 6);
        }
    }
}

// The coefficients of a polynomial do not limit the radius; those of an entire function limit it to about the unit.
TEST_CASE("the unit of time does not change the proof", "[ode][proved]") {
    const precision_scope scope(60);
    for (const int power : {-1000, -400, -3, 5, 1000}) {
        const std::string unit = "10^(" + std::to_string(power) + ")";
        const rational three = read_exact("3e" + std::to_string(power)).coefficient;
        check("y' = 1/(" + unit + "); y(0) = 1", three, {ball(4)});
        check("y' = cos(t/(" + unit + "))/(" + unit + "); y(0) = 0", three, {sin(ball(3))});
        check("y' = -y^2/(" + unit + "); y(0) = 1", three, {ball(1) / 4});
    }
}

TEST_CASE("what is 0 for all times is proved to be 0", "[ode][proved]") {
    for (const char* text : {
             "x' = y - 3*x + 2.7*y*z; y' = 1.7*y - x*z + z; z' = 2*x*y - 9*z; x(0) = 1; y(0) = 0; z(0) = 0",
             "x' = -3*x; y' = x*y/(1 + x^2); z' = y*sin(x) + z*exp(x); x(0) = 1; y(0) = 0; z(0) = 0",
             "x' = -3*x; y'' = -sin(y)*x; x(0) = 1; y(0) = 0; y'(0) = 0",
             "x' = -3*x; y' = z*tan(y) + z; z' = y^2 + z*log(1 + x) + (exp(y) - 1); x(0) = 1; y(0) = 0; z(0) = 0",
         }) {
        CAPTURE(text);
        const auto state = digits_at(text, 4, 20);
        CHECK(state == std::vector<std::string>{"6.1442123533282097587e-6", "0", "0"});
    }
    // Equilibria at exact numbers as well.
    CHECK(digits_at("x' = (x - 1)*y; y' = (x - 1) - y; x(0) = 1; y(0) = 1", 2, 10) ==
          std::vector<std::string>{"1.000000000", "0.1353352832"});
}

TEST_CASE("what only begins at 0 is not taken for 0", "[ode][proved]") {
    const precision_scope scope(40);
    const ball t = ball(1) / 4;
    // z influences y through a product of two factors that are 0 at the initial point.
    check("x' = 1; y' = x*z; z' = x; x(0) = 0; y(0) = 0; z(0) = 0", rational(1, 4), {t, t * t * t * t / 8, t * t / 2});
    check("x' = y^2; y' = z; z' = 1e-500; x(0) = 0; y(0) = 0; z(0) = 0", 1,
          {power_of_ten(-1000) / 20, power_of_ten(-500) / 2, power_of_ten(-500)});
}

// tan(t^k): k - 1 coefficients between any two are 0, or 2 k - 1.
TEST_CASE("series with gaps are as good as others", "[ode][proved]") {
    const precision_scope scope(80);
    for (const int k : {1, 2, 3, 5, 6, 17, 40, 60}) {
        for (const long digits : {5, 10, 11, 12, 20, 33}) {
            const std::string text =
                "y' = " + std::to_string(k) + "*t^" + std::to_string(k - 1) + "*(1 + y^2); y(0) = 0";
            check(text, rational(9, 10), {tan(pow(ball(9) / 10, static_cast<long>(k)))}, digits);
        }
    }
    for (const char* text : {"y' = y^2 + t; y(0) = 0", "y' = y^3 + t; y(0) = 0", "y'' = 6*y^2 + t; y(0) = 0; y'(0) = 0",
                             "x' = y; y' = x*y + t; x(0) = 0; y(0) = 0", "y' = y^2 + t^5; y(0) = 0",
                             "y' = y^2 + 1e-1000*t^7; y(0) = 0", "y' = y^2 + 1e1000*t^7; y(0) = 0"}) {
        const rational time =
            std::string(text).find("1e1000") == std::string::npos ? rational(1, 2) : rational(1, integer(1) << 400);
        const auto first = digits_at(text, time, 60);
        for (const long digits : {5, 10, 11, 12, 20, 33}) {
            const auto other = digits_at(text, time, digits);
            for (std::size_t i = 0; i < first.size(); ++i) {
                CAPTURE(text, digits);
                CHECK(is_within_unit(other[i], constant_value<ball>::of(parse_constant(first[i]).constant()), digits));
            }
        }
    }
}

// x - y is 0, which no run can prove.
TEST_CASE("a value that is not decided leaves the others", "[ode][proved]") {
    const auto part = part_of("x' = -x + z^2; y' = -y + z^2; z' = x - y; x(0) = 1/3; y(0) = 1/3; z(0) = 0",
                              {number(rational(1)), number(rational(0)), number(rational(2))}, 20);
    REQUIRE(part.missing.has_value());
    CHECK(part.missing->kind() == error_kind::undecided);
    CHECK_THAT(part.missing->what(), Catch::Contains("|z| < "));
    const precision_scope scope(60);
    for (const std::size_t i : {0U, 2U}) {
        REQUIRE(part.states[i].size() == 3);
        REQUIRE(part.states[i][0].decimal.has_value());
        REQUIRE(part.states[i][1].decimal.has_value());
        CHECK(is_within_unit(part.states[i][0].decimal->text, exp(-ball(static_cast<int>(i / 2 + 1))) / 3, 20));
        CHECK(part.states[i][1].decimal->text == part.states[i][0].decimal->text);
        CHECK_FALSE(part.states[i][2].decimal.has_value());
        const ball bound = constant_value<ball>::of(parse_constant(part.states[i][2].bound).constant());
        CHECK(certainly_less(ball(0), bound));
        CHECK(certainly_less(bound, power_of_ten(-60)));
    }
    CHECK(part.states[1][2].decimal->text == "0");
}

TEST_CASE("a time beyond the end leaves those before it", "[ode][proved]") {
    const auto part =
        part_of("y' = y^2; z' = z; y(0) = 1; z(0) = 1",
                {number(rational(2)), number(rational(1, 2)), number(rational(-1)), number(rational(3))}, 15);
    REQUIRE(part.missing.has_value());
    CHECK_THAT(part.missing->what(), Catch::Contains("time '2' ") && Catch::Contains("proved to exist up to 0.99999"));
    // z does not depend on y and is e^t at all times.
    for (const std::size_t beyond : {std::size_t{0}, std::size_t{3}}) {
        REQUIRE(part.states[beyond].size() == 2);
        CHECK(!part.states[beyond][0].decimal);
        CHECK(part.states[beyond][0].bound.empty());
    }
    CHECK(part.states[0][1].decimal->text == "7.38905609893065");
    CHECK(part.states[3][1].decimal->text == "20.0855369231877");
    REQUIRE(part.states[1].size() == 2);
    CHECK(part.states[1][0].decimal->text == "2.00000000000000");
    CHECK(part.states[1][1].decimal->text == "1.64872127070013");
    CHECK(part.states[2][0].decimal->text == "0.500000000000000");
    // x = u - 2 + 1e-60 at t = 1/2 needs more bits than the first run has, which meets the end already.
    const auto cancelled =
        part_of("u' = u^2; x' = u^2; u(0) = 1; x(0) = -1 + 1e-60", {number(rational(1, 2)), number(rational(2))}, 20);
    CHECK(cancelled.missing);
    REQUIRE(cancelled.states[0][1].decimal);
    CHECK(cancelled.states[0][1].decimal->text == "1.0000000000000000000e-60");
}

// At an equilibrium only the derivative of the flow has a time scale.
TEST_CASE("a solution that stays at an equilibrium is followed over times of any size", "[ode][proved]") {
    for (const char* scale : {"1e-1000", "1", "1e300", "1e320", "1e1000"}) {
        for (const char* start : {"1", "-1", "1 + 2^(-3000)"}) {
            CAPTURE(scale, start);
            const std::string problem = "y' = (1 - y^2)/" + std::string(scale) + "; y(0) = " + std::string(start);
            const number time = parse_constant("-5/4*" + std::string(scale)).constant();
            const auto states = proved_trajectory(explicit_system(parse(problem)), {time}, 20);
            CHECK(states[0][0].text == (start[0] == '-' ? "-1.0000000000000000000" : "1.0000000000000000000"));
        }
    }
}

// x' = 0 is not decided by balls about pi, but by sin(pi) = 0.
TEST_CASE("the derivative of a solution that rests at an irrational value is 0", "[ode][proved]") {
    const std::vector<std::string> at_rest{"3.1415926535897932385", "0"};
    CHECK(digits_at("x'' = -sin(x); x(0) = pi; x'(0) = 0", 1, 20) == at_rest);
    CHECK(digits_at("x' = y; y' = -sin(x); x(0) = pi; y(0) = 0", rational(-1000), 20) == at_rest);
}

}  // namespace query_scale_test
