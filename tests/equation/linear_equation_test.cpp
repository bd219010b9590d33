// Linear equations with polynomial coefficients, read from text.
#include "libration/equation/linear_equation.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace equation_linear_equation_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::optional<linear_equation> typed(const std::string& text) {
    return linear_equation::of(explicit_system(parse(text)));
}

}  // namespace

TEST_CASE("coefficients about the initial point, without common factors", "[equation]") {
    const auto legendre = typed("(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2");
    REQUIRE(legendre);
    REQUIRE(legendre->order() == 2);
    const rational scale = legendre->leading()[0];
    CHECK(legendre->leading() == rational_polynomial(std::vector<rational>{1, 0, -1}) * scale);
    CHECK(legendre->coefficients()[1] == rational_polynomial(std::vector<rational>{0, -2}) * scale);
    CHECK(legendre->coefficients()[0] == rational_polynomial(rational(4, 9)) * scale);
    const auto moved = typed("(1-t)^2*y' = (1-t)*y; y(1/2) = 1");  // (1/2 - s) y' = y
    REQUIRE(moved);
    CHECK(moved->leading().degree() == 1);
    CHECK(moved->leading()[0] == moved->coefficients()[0][0] * rational(-1, 2));
}

// y' = 1/(1 + t^2): (1 + t^2) y'' + 2 t y' = 0, y = t - t^3/3 + ..
TEST_CASE("a polynomial on the right is differentiated away", "[equation][proved]") {
    const precision_scope scope(30);
    const auto found = typed("y' = 1/(1+t^2); y(0) = 0");
    REQUIRE(found);
    CHECK(found->order() == 2);
    CHECK(found->coefficients()[0].is_zero());
    CHECK(contains(found->start()[1], ball(1)));
    const auto more = typed("y'' = t*y + t^2 - 3; y(0) = 2; y'(0) = 0");
    REQUIRE(more);
    REQUIRE(more->order() == 5);
    CHECK(contains(more->start()[2], ball(-3) / 2));
    CHECK(contains(more->start()[3], ball(1) / 3));   // 6 a_3 = a_0
    CHECK(contains(more->start()[4], ball(1) / 12));  // 12 a_4 = a_1 + 1
}

TEST_CASE("a singular initial point is a zero of the leading coefficient", "[equation]") {
    const auto bessel = typed("y'' + y'/t + y = 0; y(0) = 1; y'(0) = 0");
    REQUIRE(bessel);
    CHECK(bessel->leading() == rational_polynomial(std::vector<rational>{0, 1}) * bessel->leading()[1]);
    const auto removable = typed("t*y'' = t*y; y(0) = 1; y'(0) = 0");
    REQUIRE(removable);
    CHECK(removable->leading().degree() == 0);
}

TEST_CASE("what is no such equation", "[equation]") {
    CHECK_FALSE(typed("y' = y^2; y(0) = 1"));
    CHECK_FALSE(typed("y' = sin(t)*y; y(0) = 1"));
    CHECK_FALSE(typed("y' = sqrt(2)*y; y(0) = 1"));
    CHECK_FALSE(typed("y' = 1/y; y(0) = 1"));
    CHECK_FALSE(typed("x' = y; y' = -x; x(0) = 1; y(0) = 0"));
    CHECK_FALSE(typed("y' = y/(1-t); y(sqrt(1/2)) = 1"));
    CHECK_FALSE(typed("y' = 1/sqrt(t) - y; y(0) = 0"));
}

}  // namespace equation_linear_equation_test
