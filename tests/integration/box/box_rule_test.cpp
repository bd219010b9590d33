// Steps of theorem G against closed forms: of systems that grow, decay, rotate and meet a singularity, forwards and
// backwards, from points and from boxes.
#include "libration/integration/box/box_rule.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace integration_box_rule_test {

using namespace libration;
using namespace libration::ode;

namespace {

proof_route by_comparison() {
    proof_route route;
    route.integrator = integrator_choice::comparison;
    return route;
}

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

number fraction(int numerator, int denominator) { return number(rational(numerator, denominator)); }

// Every digit of the decimals at the times against the closed forms, with so many digits.
void check_values(const std::string& text, const std::vector<number>& times, long digits,
                  const std::function<std::vector<ball>(const ball& t)>& exact) {
    CAPTURE(text);
    const auto states = proved_trajectory(system_of(text), times, digits, {}, by_comparison());
    const precision_scope scope(digits + 20);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto expected = exact(constant_value<ball>::of(times[i]));
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const proved_decimal& found = states[i][k];
            CAPTURE(k, found.text);
            const ball printed = constant_value<ball>::of(as_exact_real(read_exact(found.text)));
            const ball unit = pow(ball(10), 1 - digits) * abs(expected[k]) * 2;
            CHECK(certainly_less(abs(printed - expected[k]), unit));
        }
    }
}

// The enclosure, at a time, of all solutions from a box.
std::optional<std::vector<ball>> enclosed(const std::string& text, const std::vector<ball>& box, const number& time) {
    const long bits = 200;
    const precision_scope scope(decimal_digits(bits));
    proved_march march(system_of(text), box, bits, run_bits::usual_error_bits, {}, by_comparison());
    return march.at(time);
}

ball around(long middle, long radius, long exponent) {
    return widened(ball(middle), magnitude::of(static_cast<unsigned long>(radius), exponent));
}

}  // namespace

TEST_CASE("box: values by theorem G are those of closed forms") {
    const std::vector<number> times{fraction(1, 1), fraction(7, 3), fraction(-1, 4), fraction(-2, 1)};
    check_values("x' = y; y' = -x; x(0) = 1/3; y(0) = 0", times, 30, [](const ball& t) {
        return std::vector<ball>{cos(t) / 3, -sin(t) / 3};
    });
    check_values("x' = x; y' = -2*y; x(0) = 1/3; y(0) = 2/7", times, 30, [](const ball& t) {
        return std::vector<ball>{exp(t) / 3, exp(t * -2) * 2 / 7};
    });
    // x = u, y = v + u^2 with u' = -u^2/4, v' = v cos(t).
    check_values("x' = -x^2/4; y' = (y - x^2)*cos(t) - x^3/2; x(0) = 1/3; y(0) = 10/9", times, 40, [](const ball& t) {
        const ball u = ball(1) / (ball(3) + t / 4);
        return std::vector<ball>{u, exp(sin(t)) + u * u};
    });
    check_values("x'' = -x; x(0) = 0; x'(0) = 1", {fraction(1, 2), fraction(-3, 2)}, 50, [](const ball& t) {
        return std::vector<ball>{sin(t), cos(t)};
    });
    check_values("x' = sqrt(x); y' = exp(-y); z' = tan(z/2); x(0) = 1; y(0) = 1/3; z(0) = 1/5", {fraction(1, 1)}, 20,
                 [](const ball& t) {
                     const ball r = t / 2 + 1;
                     const ball third = ball(1) / 3;
                     return std::vector<ball>{r * r, log(t + exp(third)), asin(sin(ball(1) / 10) * exp(t / 2)) * 2};
                 });
}

TEST_CASE("box: a chain of a hundred springs by its normal modes") {
    // q_i = sin(k pi i/101) cos(w t), w = 2 sin(k pi/202), k = 3.
    const auto mode = [](int i) { return "sin(3*pi*" + std::to_string(i) + "/101)"; };
    std::string text;
    for (int i = 1; i <= 100; ++i) {
        const std::string q = "q" + std::to_string(i);
        const auto at = [](int j) { return j == 0 || j == 101 ? std::string("0") : "q" + std::to_string(j); };
        text += q + "'' = " + at(i + 1) + " - 2*" + q + " + " + at(i - 1) + "; " + q + "(0) = " + mode(i) + "; " + q +
                "'(0) = 0; ";
    }
    check_values(text, {fraction(2, 1)}, 20, [&](const ball& t) {
        const ball angle = pi<ball>() * 3 / 101;
        const ball w = sin(angle / 2) * 2;
        std::vector<ball> state;
        for (int i = 1; i <= 100; ++i) {
            state.push_back(sin(angle * i) * cos(w * t));
            state.push_back(-sin(angle * i) * sin(w * t) * w);
        }
        return state;
    });
}

TEST_CASE("box: small differences of large unknowns by many bits") {
    // By fixed-point sums of the power series with 520 bits, in integers of Python.
    const std::vector<std::pair<std::string, std::string>> truth{
        {"q[1]", "0.17834646930602614424915303264049344367948626696087"},
        {"q[20]", "0.17513336422396286101555933963726307288399917474261"},
        {"p[16]", "-6.562543634387461491607101252703890751321370696632e-38"},
        {"p[19]", "-2.7658478844052619232943462420908615896016193925638e-47"},
        {"p[22]", "-2.5950197574082053909428009097515735716545965098126e-44"},
        {"p[40]", "-0.20697966470359619356110663297343918555435622071956"}};
    const std::string chain =
        "q[i]' = p[i] for i = 1..40; p[i]' = q[i+1] - 2*q[i] + q[i-1] + ((q[i+1] - q[i])^2 - (q[i] - q[i-1])^2)/4 for "
        "i = 1..40; "
        "q[0] = 0; q[41] = 0; q[i](0) = (i mod 3)/5 for i = 1..40; p[i](0) = 0 for i = 1..40";
    const auto states = proved_trajectory(system_of(chain), {fraction(1, 1)}, 45, {}, by_comparison());
    const precision_scope scope(80);
    const auto names = names_of_state(system_of(chain));
    for (const auto& [name, expected] : truth) {
        CAPTURE(name);
        const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        REQUIRE(at < names.size());
        const ball exact = constant_value<ball>::of(as_exact_real(read_exact(expected)));
        const ball found = constant_value<ball>::of(as_exact_real(read_exact(states[0][at].text)));
        CHECK(certainly_less(abs(found - exact), abs(exact) * pow(ball(10), -44)));
    }
}

TEST_CASE("box: a planned step leaves out no more than its bits") {
    // y = 1/(1 - t): all a_n are 1, and what follows N is t^(N + 1)/(1 - t).
    constexpr long bits = 400;
    const tape geometric = tape::about_points(system_of("y' = y^2; y(0) = 1"));
    step_planner planner(geometric, bits);
    for (const double way : {0.01, 0.2, 0.9, 7., HUGE_VAL}) {
        const auto plan = planner.plan(ball(0), {ball(1)}, way);
        REQUIRE(plan);
        CAPTURE(way, plan->log_of_length, plan->order);
        const double length = std::exp2(plan->log_of_length);
        CHECK((plan->order + 1) * plan->log_of_length - std::log2(1 - length) < -bits);
        CHECK((plan->order + 1) * plan->log_of_length - std::log2(1 - length) > -1.5 * bits);
        for (int n = 0; n < plan->order; ++n) {
            const auto left = static_cast<double>(plan->digits[static_cast<std::size_t>(n)]) * std::log2(10.);
            CHECK(left > bits + n * plan->log_of_length);
            CHECK(left < std::max(bits + n * plan->log_of_length, 0.) + 50);
        }
        const double steps = way / length;
        CHECK((!(steps < 50) || std::abs(steps - std::round(steps)) < steps / 1000));
    }
    CHECK_FALSE(planner.plan(ball(0), {ball(0)}, 1));
}

TEST_CASE("box: an unknown that is exactly 0 stays so beside others") {
    const auto states =
        proved_trajectory(system_of("x' = x + z*y; y' = -x + z; z' = -z^3*x; x(0) = 1/3; y(0) = 2; z(0) = 0"),
                          {fraction(2, 1)}, 20, {}, by_comparison());
    CHECK(states[0][2].text == "0");
}

TEST_CASE("box: all solutions of a box are enclosed, forwards and backwards") {
    // The image of the box by the rotation: its corners are solutions, too.
    for (const number& time : {fraction(1, 1), fraction(-1, 1), fraction(5, 2)}) {
        const auto found =
            enclosed("x' = y; y' = -x; x(0) = 1; y(0) = 0", {around(1, 1, -40), around(0, 1, -40)}, time);
        REQUIRE(found);
        const precision_scope scope(60);
        const ball t = constant_value<ball>::of(time);
        const ball radius = ball(1) / pow(ball(2), 40L);
        for (const int a : {-1, 1}) {
            for (const int b : {-1, 1}) {
                const ball x = ball(1) + radius * a;
                const ball y = radius * b;
                CHECK(contains((*found)[0], x * cos(t) + y * sin(t)));
                CHECK(contains((*found)[1], y * cos(t) - x * sin(t)));
            }
        }
    }
    // y = 1/(1/c - t), where the errors grow by (c/(1 - c t))^2.
    const auto pole = enclosed("y' = y^2; y(0) = 1", {around(1, 1, -60)}, fraction(9, 10));
    REQUIRE(pole);
    const precision_scope scope(60);
    for (const int a : {-1, 1}) {
        const ball c = ball(1) + ball(a) / pow(ball(2), 60L);
        CHECK(contains((*pole)[0], ball(1) / (ball(1) / c - ball(9) / 10)));
    }
}

TEST_CASE("box: an unknown that is 0 along the middle of a box alone does not stay 0") {
    // z = x(0) (1 - exp(-t)).
    const auto found = enclosed("z' = x; x' = -x; z(0) = 0; x(0) = 0", {ball(0), around(0, 1, -40)}, fraction(1, 1));
    REQUIRE(found);
    const precision_scope scope(60);
    CHECK(contains((*found)[0], (ball(1) - exp(ball(-1))) / pow(ball(2), 40L)));
    CHECK(magnitude::radius_of((*found)[0]) < magnitude::of(3, -40));
}

TEST_CASE("box: a wide box in which a solution ends is not enclosed") {
    // From y(0) = 10 x ends at t = 0.116; the radii of the comparison system about 0 are small again at t = 1.
    CHECK_FALSE(enclosed("x' = -10*x + x^2 + 40*y; y' = -10*y; x(0) = 0; y(0) = 0", {ball(0), around(0, 10, 0)},
                         fraction(1, 1)));
}

TEST_CASE("box: a box is not enclosed beyond the end of solutions that leave its tube within a piece") {
    // About x = y = c only z limits the steps, to some hundreds. From y = c + v, x is c + sqrt(v) tan(sqrt(v) t), for
    // v = 2^-10 up to t = 16 pi.
    constexpr long c = 1'000'000;
    const auto at = [&](const number& time) {
        return enclosed(
            "x' = (x - 1000000)^2 + (y - 1000000); y' = 0; z' = -z/1000; x(0) = 1000000; y(0) = 1000000; z(0) = 1",
            {ball(c), around(c, 1, -10), ball(1)}, time);
    };
    CHECK_FALSE(at(fraction(100, 1)));
    CHECK_FALSE(at(fraction(-100, 1)));
    const auto before = at(fraction(2, 1));
    REQUIRE(before);
    const precision_scope scope(60);
    CHECK(contains(before->front(), ball(c) + tan(ball(1) / 16) / 32));
    CHECK(contains(before->front(), ball(c) - tanh(ball(1) / 16) / 32));
}

TEST_CASE("box: the derivative of the flow is not carried") {
    const explicit_system system = system_of("x' = y; y' = -x; x(0) = 1; y(0) = 0");
    proved_march march(system, 100, {}, run_bits::usual_error_bits, by_comparison());
    CHECK_THROWS_AS(march.keep_derivative(), error);
}

TEST_CASE("box: a solution is followed up to its singularity, and not beyond") {
    const auto part = proved_part_of_trajectory(system_of("y' = y^2; z' = y*z; y(0) = 1; z(0) = 1"),
                                                {fraction(99, 100), fraction(101, 100)}, 15, {}, by_comparison());
    REQUIRE(part.missing);
    REQUIRE(part.states[0].size() == 2);
    CHECK(part.states[0][0].decimal->text == "100.000000000000");
    CHECK(part.states[1].empty());
}

}  // namespace integration_box_rule_test
