// Solutions of equations with roots of the time compared with closed forms: before, at and after the time of the root,
// from it, in both directions, with events and derivatives.
#include "libration/integration/root/root_time.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "libration/query/states.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace integration_root_root_time_test {

using namespace libration;
using namespace libration::ode;

namespace {

using closed_form = std::function<ball(const ball& t)>;

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }
number typed(const std::string& text) { return parse_constant(text).constant(); }

// |x|^(p/q), of numbers close to 0 also if the ball contains negative ones.
ball power_of_size(const ball& x, long p, unsigned long q) {
    ball result;
    arb_abs(result.handle(), x.handle());
    arb_nonnegative_part(result.handle(), result.handle());
    arb_root_ui(result.handle(), result.handle(), q, ball::working_bits());
    arb_pow_ui(result.handle(), result.handle(), static_cast<ulong>(p), ball::working_bits());
    return result;
}

// The value of an unknown at each time is the closed form, and narrower than 2^-(bits - lost).
void check(const std::string& text, const std::vector<std::string>& times, const closed_form& exact,
           std::size_t place = 0, long lost = 24) {
    for (const long bits : {70L, 300L}) {
        const precision_scope scope(decimal_digits(bits) + 30);
        std::vector<number> at;
        for (const std::string& each : times) {
            at.push_back(typed(each));
        }
        const auto found = enclosed_trajectory(system_of(text), at, bits);
        REQUIRE(found);
        for (std::size_t k = 0; k < times.size(); ++k) {
            CAPTURE(text, times[k], bits);
            const ball value = exact(constant_value<ball>::of(at[k]));
            const ball& enclosed = (*found)[k][place];
            CHECK(overlaps(enclosed, value));
            CHECK(certainly_less(enclosed - exact_midpoint(enclosed), pow(ball(2), lost - bits)));
        }
    }
}

// 3/4 (t - tau)^(4/3), a primitive of cbrt(t - tau).
ball primitive_of_cube_root(const ball& away) { return ball(3) * power_of_size(away, 4, 3) / 4; }

}  // namespace

TEST_CASE("solutions continue through the time of a cube root", "[ode][proved][root_time]") {
    const std::vector<std::string> times{"1/2", "999/1000", "1", "1001/1000", "3/2", "2", "5"};
    const closed_form angle = [](const ball& t) { return primitive_of_cube_root(t - 1) - ball(3) / 4; };
    check("y' = cbrt(t - 1)*y; y(0) = 1", times, [&](const ball& t) { return exp(angle(t)); });
    check("y' = cbrt(1 - t)*y; y(0) = 1", times, [&](const ball& t) { return exp(-angle(t)); });
    check("y' = cbrt(5*t - 5)*y; y(0) = 1", times,
          [&](const ball& t) { return exp(power_of_size(ball(5), 1, 3) * angle(t)); });
    // From a distance that is not the cube of a fraction, to times close to each other in the first steps.
    check("y' = cbrt(t - 1)*y; y(1/3) = 1", {"0.34", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.1", "1.6"},
          [&](const ball& t) { return exp(angle(t) - angle(ball(1) / 3)); });
    // A rotation, whose set turns on the way.
    const std::string turns = "x' = cbrt(t - 1)*y; y' = -cbrt(t - 1)*x; x(0) = 0; y(0) = 1";
    check(turns, times, [&](const ball& t) { return sin(angle(t)); });
    check(
        turns, times, [&](const ball& t) { return cos(angle(t)); }, 1);
    // Backwards, from beyond the root, and with an equation of second order.
    check("y' = cbrt(t - 1)*y; y(2) = 1", {"3/2", "1", "1/2", "-1"}, [&](const ball& t) { return exp(angle(t)); });
    check("y'' = cbrt(t - 1); y(0) = -9/28; y'(0) = 3/4", {"1/2", "3"}, [](const ball& t) {
        const ball seventh = ball(9) * power_of_size(t - 1, 7, 3) / 28;
        return arb_is_negative((t - 1).handle()) != 0 ? -seventh : seventh;
    });
}

TEST_CASE("several roots are crossed one after the other", "[ode][proved][root_time]") {
    check("y' = cbrt(t - 1) + cbrt(t - sqrt(2)) + cbrt(t - 1.001); y(0) = 0", {"1.0005", "1.2", "1.5", "3"},
          [](const ball& t) {
              ball sum(0);
              for (const char* tau : {"1", "sqrt(2)", "1001/1000"}) {
                  const ball root = constant_value<ball>::of(typed(tau));
                  sum += primitive_of_cube_root(t - root) - primitive_of_cube_root(root);
              }
              return sum;
          });
}

TEST_CASE("solutions begin and end at a root", "[ode][proved][root_time]") {
    const std::vector<std::string> after{"0", "1e-30", "1/1000", "1", "4"};
    check("y' = sqrt(t)*y; y(0) = 1", after, [](const ball& t) { return exp(ball(2) * power_of_size(t, 3, 2) / 3); });
    check("y' = y/sqrt(t); y(0) = 1", after, [](const ball& t) { return exp(2 * power_of_size(t, 1, 2)); });
    check("y' = t^(2/3)*cos(y)^2; y(0) = 0", after, [](const ball& t) {
        ball result = ball(3) * power_of_size(t, 5, 3) / 5;
        arb_atan(result.handle(), result.handle(), ball::working_bits());
        return result;
    });
    check("y'' = sqrt(t); y(0) = 1; y'(0) = 0", after,
          [](const ball& t) { return ball(1) + ball(4) * power_of_size(t, 5, 2) / 15; });
    check("y' = cbrt(t - 1)*y; y(1) = 1", {"1", "1.0001", "3"},
          [](const ball& t) { return exp(primitive_of_cube_root(t - 1)); });
    // Up to the last time at which the root is real, and not beyond it.
    const std::string ends = "y' = (1 - t)^(1/3)*y; y(0) = 1";
    check(ends, {"1/2", "1"}, [](const ball& t) { return exp(ball(3) / 4 - primitive_of_cube_root(t - 1)); });
    const auto beyond = proved_part_of_trajectory(system_of(ends), {typed("1"), typed("2")}, 20);
    CHECK(beyond.states[0].front().decimal);
    REQUIRE(beyond.missing);
    CHECK_THAT(beyond.missing->what(), Catch::Contains("is proved to exist up to 1.0"));
    // The other side, backwards.
    check("y' = sqrt(t)*y; y(1) = 1", {"1/2", "1e-9", "0"},
          [](const ball& t) { return exp(ball(2) * (power_of_size(t, 3, 2) - 1) / 3); });
}

// The neutral atom, y'' = y^(3/2)/sqrt(t), compared with its series in powers of sqrt(t) and steps in MPFR, two runs of
// which agree.
TEST_CASE("the atom of Thomas and Fermi is proved from its initial point", "[ode][proved][root_time]") {
    const explicit_system atom = system_of(std::string(problem_text("thomas_fermi")));
    const std::vector<number> times{typed("1/100"), typed("1"), typed("10")};
    const auto proved = proved_trajectory(atom, times, 30);
    const auto computed = trajectory(atom, times, 40);
    const precision_scope scope(60);
    for (std::size_t k = 0; k < times.size(); ++k) {
        for (std::size_t j = 0; j < 2; ++j) {
            CHECK(tests::within_a_unit(proved[k][j], ball(computed[k][0][j]), 30));
        }
    }
}

TEST_CASE("events on both sides of a root, and after it, are found", "[ode][proved][root_time]") {
    const precision_scope scope(60);
    const auto times_of = [](const std::string& text, const rational& level, long count) {
        event_request request{.g = unknown("y") - ode::expression(level)};
        request.count = count;
        std::vector<proved_decimal> times;
        for (const printed_event& each : proved_events(system_of(text), request, 30)) {
            times.push_back(each.time);
        }
        return times;
    };
    // y = 3/4 ((t - 1)^(4/3) - 1) is -1/2 at t = 1 -+ (1/3)^(3/4), and least at t = 1.
    const auto smooth = times_of("y' = cbrt(t - 1); y(0) = 0", rational(-1, 2), 2);
    const ball away = power_of_size(ball(1) / 3, 3, 4);
    CHECK(tests::within_a_unit(smooth.at(0), ball(1) - away, 30));
    CHECK(tests::within_a_unit(smooth.at(1), ball(1) + away, 30));
    // y = 3/2 ((t - 1)^(2/3) - 1) has a cusp at t = 1.
    const auto cusp = times_of("y' = 1/cbrt(t - 1); y(0) = 0", rational(-1), 2);
    CHECK(tests::within_a_unit(cusp.at(0), ball(1) - power_of_size(ball(1) / 3, 3, 2), 30));
    CHECK(tests::within_a_unit(cusp.at(1), ball(1) + power_of_size(ball(1) / 3, 3, 2), 30));
    // y = 2/3 t^(3/2), and 2 sqrt(t), whose equation is singular in sqrt(t), too.
    CHECK(times_of("y' = sqrt(t); y(0) = 1", rational(5, 3), 1).front().text.substr(0, 6) == "1.0000");
    CHECK(times_of("y' = 1/sqrt(t); y(0) = 0", rational(2), 1).front().text.substr(0, 6) == "1.0000");
}

// x = x0 exp(3/4 ((t - 1)^(4/3) - 1)) increases with x0: at t = 2 it is x0, and at t = 1 least.
TEST_CASE("sets of solutions cross a root", "[ode][proved][root_time][sets]") {
    const auto growth = parse("x' = cbrt(t - 1)*x; x(0) = [0.9, 1.1]");
    const auto found = enclosed_solutions(growth, {.spans = {at_time(typed("2")), {typed("0"), typed("2")}}});
    REQUIRE_FALSE(found.missing);
    const precision_scope scope(30);
    const auto between = [](const closed_interval& of, const ball& lower, const ball& upper) {
        CHECK_FALSE(certainly_less(lower, of.lower));
        CHECK_FALSE(certainly_less(of.upper, upper));
        const ball width = upper - lower;
        CHECK(certainly_less(lower - of.lower, width / 4));
        CHECK(certainly_less(of.upper - upper, width / 4));
    };
    between(found.values[0][0], ball(9) / 10, ball(11) / 10);
    between(found.values[1][0], ball(9) / 10 * exp(ball(-3) / 4), ball(11) / 10);
}

TEST_CASE("the derivative of the flow continues through a root, and from it", "[ode][proved][root_time]") {
    const precision_scope scope(60);
    const auto derivative_of = [](const std::string& text, const ball& time) {
        proved_march march(system_of(text), 100);
        march.keep_derivative();
        REQUIRE(march.at(time));
        return march.derivative_at(time)[0][0];
    };
    for (const char* t : {"9/10", "1", "2"}) {
        const ball time = constant_value<ball>::of(typed(t));
        CHECK(overlaps(derivative_of("y' = cbrt(t - 1)*y; y(0) = 1", time),
                       exp(primitive_of_cube_root(time - 1) - ball(3) / 4)));
    }
    CHECK(overlaps(derivative_of("y' = sqrt(t)*y; y(0) = 1", ball(4)), exp(ball(16) / 3)));
}

}  // namespace integration_root_root_time_test
