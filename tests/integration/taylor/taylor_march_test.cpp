// Integration in time: closed forms, integration backwards, dense output, and digits on which two runs agree.
#include "libration/integration/taylor/taylor_march.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/error.hpp"
#include "scalars.hpp"

namespace integration_taylor_taylor_march_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

explicit_system solved(const std::string& text) { return explicit_system(parse(text)); }

const std::string swinging = "x'' = -sin(x); x(0) = 5/2; x'(0) = -3/10";

}  // namespace

TEMPLATE_LIST_TEST_CASE("a march reaches closed forms forwards and backwards", "[ode][step]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::exp;
    using std::sin;
    using std::sqrt;
    // y = 1/(1 + e^-t), a shift of it and e^(sin t): some epsilon per step, some ten steps.
    taylor_march<T> logistic(solved("y' = y*(1 - y); y(0) = 1/2"));
    for (const int time : {3, 7, -5, 0, 1}) {
        CHECK_THAT(logistic.advance_to(T(time))[0][0], near<T>(T(1 / (1 + exp(T(-time)))), 100));
    }
    taylor_march<T> driven(solved("y' = y*cos(t); y(0) = 1"));
    CHECK_THAT(driven.advance_to(T(10))[0][0], near<T>(T(exp(sin(T(10)))), 200));
    // A polynomial, whose step is unlimited; and the first step of a series in sqrt(t): y = e^(2 sqrt t).
    taylor_march<T> polynomial(solved("y'' = 6*t; y(0) = 1; y'(0) = 0"));
    CHECK(polynomial.advance_to(T(100))[0][0] == 1'000'001);
    taylor_march<T> root(solved("sqrt(t)*y' = y; y(0) = 1"));
    CHECK_THAT(root.advance_to(T(T(1) / 16))[0][0], near<T>(T(exp(T(T(1) / 2))), 50));
    CHECK_THAT(root.advance_to(T(9))[0][0], near<T>(T(exp(T(6))), 200));
}

TEST_CASE("a march does not depend on the times that are asked for", "[ode][step]") {
    const auto system = solved(swinging);
    taylor_march<double> once(system);
    const double at_ten = once.advance_to(10)[0][0];
    taylor_march<double> often(system);
    for (int i = 1; i < 1000; ++i) {
        often.advance_to(i / 100.0);
    }
    CHECK(often.advance_to(10)[0][0] == at_ten);
    CHECK(often.steps() == once.steps());
    const double back = often.advance_to(2.5)[0][0];
    taylor_march<double> fresh(system);
    CHECK(fresh.advance_to(2.5)[0][0] == back);
    CHECK(fresh.advance_to(0)[0][0] == 2.5);
}

TEST_CASE("steps that end before a singularity say where", "[ode][step]") {
    taylor_march<double> tangent(solved("y' = 1 + y^2; y(0) = 0"));
    CHECK(tangent.advance_to(1.5)[0][0] == Approx(std::tan(1.5)));
    CHECK_THROWS_WITH(
        tangent.advance_to(2),
        "time '2.000000000' is not reached: the steps become too small near 1.570796327, where a singularity is "
        "close");
}

TEST_CASE("the length of a step is the least of the last roots over e^2", "[ode][step]") {
    // Coefficients 2^-n: R = 2, R/e^2 = 0.2706...
    const auto h = taylor_step(0, {{19, -19}, {20, -20}});
    CHECK(std::ldexp(h.mantissa, static_cast<int>(h.exponent)) == Approx(2 / std::exp(2.0)).epsilon(1e-3));
    CHECK(taylor_step(0, {{19, exponent_of_zero}, {20, exponent_of_zero}}).mantissa == 0);
    CHECK(taylor_step(0, {{19, exponent_of_zero}, {20, -20}}).mantissa == h.mantissa);
    CHECK(taylor_order(53) == 21);
}

TEST_CASE("steps of less accuracy are longer, and as accurate as they say", "[ode][step]") {
    CHECK(ode::step_accuracy::of<double>(40).order == 22);
    CHECK(ode::step_accuracy::of<mpfr>(100).order == ode::taylor_order(100));
    const precision_scope scope(50);
    // y = 1/(1 - t), all coefficients 1: steps of 2^(-bits/order) of the distance from the pole.
    const ode::explicit_system system(ode::parse("y' = y^2; y(0) = 1"));
    ode::taylor_march<mpfr> full(system);
    ode::taylor_march<mpfr> rough(system, ode::step_accuracy{80, 20});
    CHECK(abs(mpfr(full.length() - exp(mpfr(-2)))) < 0.01);
    CHECK(abs(mpfr(rough.length() - 1 / mpfr(16))) < 0.001);
    ode::taylor_march<mpfr> best(system, ode::step_accuracy::of<mpfr>(80));
    const mpfr t = mpfr(99) / 100;
    CHECK(abs(mpfr(full.advance_to(t)[0][0] - 100)) < mpfr("1e-46"));
    // Some 40 steps, each with an error of 2^-80 = 8e-25 of y, which grows by y/y_before at most 100 times.
    const mpfr error = abs(mpfr(best.advance_to(t)[0][0] - 100));
    CHECK(error < mpfr("1e-19"));
    CHECK(error > mpfr("1e-30"));
    CHECK(best.steps() <= full.steps());
}

TEST_CASE("trajectories have the digits that were asked for", "[ode][trajectory]") {
    const precision_scope scope(60);
    // Lorenz' system loses four digits up to t = 10.
    const auto lorenz = solved("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 0; z(0) = 0");
    const auto ten = number(rational(10));
    const auto few = trajectory(lorenz, {ten, number(), number(rational(1))}, 20);
    const auto many = trajectory(lorenz, {ten, number(), number(rational(1))}, 40);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const mpfr error = abs(mpfr(few[i][k][0] - many[i][k][0]));
            CHECK(error <= abs(many[i][k][0]) * pow(mpfr(10), -20));
        }
    }
    CHECK(few[1][0][0] == 1);
    CHECK(few[1][1][0] == 0);
}

// y = cos t from t = 1, instead of the initial point of the system: some operations per step, some ten steps.
TEST_CASE("a march begins at any state, and its polynomials are the solution", "[ode][step]") {
    constexpr double tolerance = 100 * std::numeric_limits<double>::epsilon();
    taylor_march<double> march(solved("y'' = -y; y(0) = 5; y'(0) = 7"));
    march.begin_at(1, {{std::cos(1.0), -std::sin(1.0)}});
    CHECK(std::abs(march.advance_to(4)[0][0] - std::cos(4.0)) <= tolerance);
    CHECK(march.advance_to(1)[0][0] == std::cos(1.0));
    int steps = 0;
    for (; march.step_towards(-20); ++steps) {
        const double* const y = march.coefficients(0, 0);
        CHECK(std::abs(y[0] - std::cos(march.centre())) <= tolerance);
        CHECK(std::abs(2 * y[2] + std::cos(march.centre())) <= tolerance);
        CHECK(march.coefficients(0, 1)[0] == y[1]);
    }
    CHECK(steps > 1);
    CHECK(march.centre() + 20 <= march.length());
    CHECK(std::abs(march.advance_to(-20)[0][0] - std::cos(20.0)) <= tolerance);
}

}  // namespace integration_taylor_taylor_march_test
