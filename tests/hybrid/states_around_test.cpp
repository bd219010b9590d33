// Enclosures of solutions over a short ball of times: exp and a quadratic equation.
#include "libration/hybrid/states_around.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace ode_states_around_test {

using namespace libration;
using namespace libration::ode;

namespace {

// A ball about half an integer.
ball around(int halves, unsigned long radius, long exponent) {
    return widened(ball(halves) / 2, magnitude::of(radius, exponent));
}

first_order_form form_of(const std::string& text) { return first_order_form(explicit_system(parse(text))); }

}  // namespace

TEST_CASE("the box contains the solutions through each state at each time, at all times", "[ode][proved][hybrid]") {
    const precision_scope scope(40);
    const auto form = form_of("y' = y; y(0) = 1");
    const ball state = around(2, 1, -10);
    const ball times = around(1, 1, -3);
    const auto box = states_around(form, {state}, times);
    REQUIRE(box);
    // Any two times of the ball are at most 1/4 apart.
    CHECK(contains(box->front(), lower_bound(state) * exp(ball(-1) / 4)));
    CHECK(contains(box->front(), upper_bound(state) * exp(ball(1) / 4)));
    CHECK(magnitude::radius_of(box->front()) < magnitude(1U));
    const ball begin = lower_bound(times);
    const auto moved = states_moved(form, {state}, times, *box, begin);
    CHECK(contains(moved.front(), lower_bound(state) * exp(ball(-1) / 4)));
    CHECK(contains(moved.front(), state));
    CHECK(contains(moved.front(), upper_bound(state) * exp(ball(-1) / 8)));
    CHECK_FALSE(contains(moved.front(), ball(3) / 2));
    // Backwards y' = -y grows, faster than at the states themselves.
    const auto falling = form_of("y' = -y; y(0) = 1");
    const auto around_falling = states_around(falling, {state}, times);
    REQUIRE(around_falling);
    const auto earlier = states_moved(falling, {state}, times, *around_falling, begin);
    CHECK(contains(earlier.front(), upper_bound(state) * exp(ball(1) / 4)));
}

TEST_CASE("no box is found where a solution may not exist", "[ode][proved][hybrid]") {
    const precision_scope scope(40);
    const auto form = form_of("y' = y^2; y(0) = 1");
    // The solution through 8 ends 1/8 later.
    CHECK_FALSE(states_around(form, {ball(8)}, around(0, 1, -3)));
    const auto box = states_around(form, {ball(8)}, around(0, 1, -8));
    REQUIRE(box);
    CHECK(contains(box->front(), ball(1) / (ball(1) / 8 - ball(1) / 128)));
    CHECK(contains(box->front(), ball(1) / (ball(1) / 8 + ball(1) / 128)));
}

TEST_CASE("constants and exact zeros remain exact", "[ode][proved][hybrid]") {
    const precision_scope scope(40);
    const auto form = form_of("x'' = 0; x(0) = 1; x'(0) = 0");
    const auto box = states_around(form, {ball(1), ball(0)}, around(0, 1, -3));
    REQUIRE(box);
    CHECK(is_exact((*box)[0]));
    CHECK(is_exact((*box)[1]));
}

}  // namespace ode_states_around_test
