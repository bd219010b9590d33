// The fixed-step Runge-Kutta method of any equation, against closed forms and the pendulum's own.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/fixed_step/runge_kutta.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "scalars.hpp"

namespace integration_fixed_step_runge_kutta_test {

using namespace libration;
using namespace libration::tests;

namespace {

// |y(1) - e| of y' = y in steps of h.
mpfr error_at_one(const mpfr& h) {
    const ode::explicit_system system(ode::parse("y' = y; y(0) = 1"));
    ode::fixed_runge_kutta<mpfr> march(system, h);
    return abs(march.advance_to(mpfr(1))[0][0] - exp(mpfr(1)));
}

}  // namespace

TEST_CASE("one step of Runge-Kutta is the Taylor polynomial of degree 4 of exp", "[integration]") {
    const precision_scope precision(40);
    const ode::explicit_system system(ode::parse("y' = y; y(0) = 1"));
    ode::fixed_runge_kutta<mpfr> march(system, mpfr(1));
    CHECK(abs(march.advance_to(mpfr(1))[0][0] - mpfr(65) / 24) < mpfr("1e-38"));
}

TEST_CASE("the error of Runge-Kutta is of the fourth order", "[integration]") {
    const precision_scope precision(40);
    const mpfr ratio = error_at_one(mpfr(1) / 20) / error_at_one(mpfr(1) / 40);
    CHECK(ratio > 15);
    CHECK(ratio < 17);
}

TEST_CASE("the general Runge-Kutta method is the pendulum's for the pendulum, forwards and backwards",
          "[integration]") {
    const precision_scope precision(40);
    const ode::explicit_system system(ode::parse("x'' = -sin(x); x(0) = 2; x'(0) = 1/2"));
    ode::fixed_runge_kutta<mpfr> march(system, mpfr(1) / 100);
    runge_kutta_march<mpfr> own({mpfr(2), mpfr(1) / 2}, mpfr(1) / 100);
    for (const mpfr& time : {mpfr(3), mpfr("3.0042"), mpfr(-1)}) {
        const auto& state = march.advance_to(time);
        const auto expected = own.advance_to(time);
        // A few hundred steps of some roundings each.
        CHECK(abs(state[0][0] - expected.value) < mpfr("1e-36"));
        CHECK(abs(state[0][1] - expected.slope) < mpfr("1e-36"));
    }
}

TEST_CASE("equations that depend on the time are evaluated at the stages", "[integration]") {
    // y' = t^3: Simpson's rule is exact for it.
    const precision_scope precision(40);
    const ode::explicit_system system(ode::parse("y' = t^3; y(0) = 0"));
    ode::fixed_runge_kutta<mpfr> march(system, mpfr(1) / 3);
    CHECK(abs(march.advance_to(mpfr(2))[0][0] - 4) < mpfr("1e-37"));
}

}  // namespace integration_fixed_step_runge_kutta_test
