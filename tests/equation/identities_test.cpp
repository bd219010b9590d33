// Identities between expressions, of which the truth is known by hand.
#include "libration/equation/identities.hpp"

#include <catch2/catch.hpp>

namespace equation_identities_test {

using namespace libration;
using namespace libration::ode;

TEST_CASE("an expression is identically 0 if all its coefficients are", "[ode][identities]") {
    const auto x = unknown("x");
    const auto v = unknown("v");
    const auto t = variable();
    CHECK(is_identically_zero(ode::expression()));
    CHECK(is_identically_zero(2 * x * v - 2 * v * x));
    CHECK(is_identically_zero(pow(x + v, 3) - (pow(x, 3) + 3 * x * x * v + 3 * x * v * v + pow(v, 3))));
    CHECK(is_identically_zero(sin(x) * t - t * sin(x)));
    CHECK(is_identically_zero((x + 1) * (1 / v) - x / v - 1 / v));
    CHECK(is_identically_zero(sqrt(ode::expression(2)) * x * sqrt(ode::expression(2)) - 2 * x));
    CHECK_FALSE(is_identically_zero(x));
    CHECK_FALSE(is_identically_zero(ode::expression(rational(1, 1'000'000'000)) * x));
    CHECK_FALSE(is_identically_zero(x * x - v * v));
    CHECK_FALSE(is_identically_zero(sin(x) - sin(v)));
    // True, but not found: it proves nothing.
    CHECK_FALSE(is_identically_zero(sin(x) * sin(x) + cos(x) * cos(x) - 1));
}

TEST_CASE("an expression vanishes with another one if it is 0 where that is", "[ode][identities]") {
    const auto x = unknown("x");
    const auto v = unknown("v");
    const auto t = variable();
    CHECK(vanishes_with(x - 2, x - 2));
    CHECK(vanishes_with(v * (2 * x - 4), x - 2));
    CHECK(vanishes_with(sin(x - t) * v, x - t));
    CHECK(vanishes_with(pow(x, 3) - 8, x - 2));
    CHECK(vanishes_with(3 * (x * x + v * v - 1), x * x + v * v - 1));
    CHECK(vanishes_with(x * v - t * v, 2 * t - 2 * x));
    CHECK_FALSE(vanishes_with(x - 3, x - 2));
    CHECK_FALSE(vanishes_with(v, x));
    CHECK_FALSE(vanishes_with(x, x * x - 1));
    CHECK_FALSE(vanishes_with(v / x, x));  // not defined there
}

}  // namespace equation_identities_test
