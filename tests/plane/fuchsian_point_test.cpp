// Exponents, logarithms and apparent singular points of equations with known solutions.
#include "libration/plane/fuchsian_point.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"

namespace plane_fuchsian_point_test {

using namespace libration;
using namespace libration::ode;

namespace {

fuchsian_point point_of(const std::string& text, const std::vector<rational>& factor) {
    return {*linear_equation::of(explicit_system(parse(text))), rational_polynomial(factor)};
}

const std::vector<rational> at_one{-1, 1};

}  // namespace

TEST_CASE("two equal exponents have a logarithm", "[plane][proved]") {
    const auto legendre = point_of("(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2", at_one);
    REQUIRE(legendre.is_regular());
    REQUIRE(legendre.classes().size() == 1);
    CHECK(legendre.classes()[0].exponent == 0);
    CHECK(legendre.classes()[0].offsets == std::vector<std::pair<long, int>>{{0, 2}});
    CHECK(legendre.classes()[0].solutions[1].v[0].size() == 2);
    CHECK_FALSE(legendre.has_single_values());
}

// y = (1 - t)^2, 1: exponents 0 and 2 without a logarithm; with + y a logarithm: x y'' = y' - y gives v_1 = 1, then 0 = (2 - 2) v_2 - v_1.
TEST_CASE("exponents that differ by an integer", "[plane][proved]") {
    const auto apparent = point_of("(1-t)*y'' = -y'; y(0) = 1; y'(0) = 1", at_one);
    CHECK(apparent.is_apparent());
    CHECK(apparent.classes()[0].last() == 2);
    const auto logarithm = point_of("(1-t)*y'' = -y' - y; y(0) = 1; y'(0) = 1", at_one);
    CHECK_FALSE(logarithm.is_apparent());
    CHECK(logarithm.classes()[0].solutions[0].v[2].size() == 2);
    const auto pole = point_of("y' = 2*y/(1-t); y(0) = 1", at_one);
    CHECK(pole.has_single_values());
    CHECK_FALSE(pole.is_apparent());
    CHECK(pole.classes()[0].exponent == -2);
}

TEST_CASE("exponents at conjugate points, irrational ones and irregular points", "[plane][proved]") {
    // y = (1 + t^2)^(1/3)
    const auto pair = point_of("(1+t^2)*y' = 2/3*t*y; y(0) = 1", {1, 0, 1});
    CHECK(pair.classes()[0].exponent == rational(1, 3));
    CHECK(pair.other_exponents().empty());
    // e (e - 1) + 3 e... of (1-t)^2 y'' + 3 (1-t) y' + y = 0: e^2 - 4 e + 1
    const auto irrational = point_of("(1-t)^2*y'' + 3*(1-t)*y' + y = 0; y(0) = 1; y'(0) = 0", at_one);
    CHECK(irrational.classes().empty());
    REQUIRE(irrational.other_exponents().size() == 3);
    CHECK(irrational.other_exponents()[1] == irrational.other_exponents()[2] * rational(-4));
    CHECK_FALSE(point_of("(1-t)^2*y' = y; y(0) = 1", at_one).is_regular());
}

// Bessel's equation of order 1 has 1 and -1 at 0; J_1 there, and the other solution with a logarithm: x^-1 (1 + v x^2 log x + ..).
TEST_CASE("a singular initial point, in powers of t itself", "[plane][proved]") {
    const auto bessel = point_of("t^2*y'' + t*y' + (t^2-1)*y = 0; y(0) = 0; y'(0) = 1/2", {0, 1});
    REQUIRE(bessel.is_start());
    REQUIRE(bessel.is_regular());
    REQUIRE(bessel.classes().size() == 1);
    CHECK(bessel.classes()[0].exponent == -1);
    CHECK(bessel.classes()[0].offsets == std::vector<std::pair<long, int>>{{0, 1}, {2, 1}});
    REQUIRE(bessel.classes()[0].solutions[0].v[2].size() == 2);
    // ((1 + S)^2 - 1) v_2 = -v_0, of which S^1 gives 2 v = -1
    CHECK(bessel.classes()[0].solutions[0].v[2][1] == rational_polynomial(rational(-1, 2)));
    const auto elliptic = point_of("t*(1-t)*y'' + (1-2*t)*y' - y/4 = 0; y(0) = 4; y'(0) = 1", {0, 1});
    CHECK(elliptic.coefficients()[1][1] == elliptic.coefficients()[1][0] * rational(-2));
    CHECK_FALSE(elliptic.has_single_values());
    CHECK_FALSE(point_of("(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2", at_one).is_start());
}

}  // namespace plane_fuchsian_point_test
