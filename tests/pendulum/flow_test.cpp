#include "libration/pendulum/flow.hpp"

#include <catch2/catch.hpp>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_flow_test {

using namespace libration;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the flow follows the exact solution", "[pendulum][flow]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Three units per step and the growth of the flow, which is below e^3 here.
    const auto expected = state_of<T>(with_state("1", "1/2"), "3");
    flow<T> along(T(1), T(1) / 2);
    const auto state = along.advance_to(T(3));
    CHECK_THAT(state.theta.re, near<T>(expected.theta, 200, T(1)));
    CHECK_THAT(state.omega.re, near<T>(expected.omega, 200, T(1)));
    CHECK(state.theta.im == 0);
}

TEST_CASE("the flow keeps the energy in complex time too, and returns on a closed path around nothing",
          "[pendulum][flow]") {
    const precision_scope precision(40);
    flow<mpfr> along(mpfr(1), mpfr(0));
    const mpfr third = mpfr(1) / 3;
    const auto there = along.advance_to(third, third);
    const auto energy = there.omega * there.omega / mpfr(2) - there.cosine;
    CHECK(abs(energy.re + cos(mpfr(1))) < mpfr("1e-38"));
    CHECK(abs(energy.im) < mpfr("1e-38"));
    along.advance_to(mpfr(0), third);
    const auto back = along.advance_to(mpfr(0), mpfr(0));
    CHECK(modulus_of(back.theta - complex_number<mpfr>{mpfr(1), mpfr(0)}) < mpfr("1e-38"));
    CHECK(modulus_of(back.omega) < mpfr("1e-38"));
}

// theta(i y) from rest at 60 degrees is 2 asin(k cd(i y, k)) = 2 asin(k nd(y, k')), k = 1/2:
// mpmath 1.3: mp.dps=40; 2*asin(mpf(1)/2*ellipfun('nd', mpf(1)/2, m=mpf(3)/4)).
TEST_CASE("in imaginary time the flow climbs as the dual motion does", "[pendulum][flow]") {
    const precision_scope precision(40);
    flow<mpfr> along(pi<mpfr>() / 3, mpfr(0));
    const auto state = along.advance_to(mpfr(0), mpfr(1) / 2);
    CHECK_THAT(state.theta.re, near<mpfr>(decimal("1.156539760549013787669993129"), 0));
    CHECK(abs(state.theta.im) < mpfr("1e-38"));
}

}  // namespace pendulum_flow_test
