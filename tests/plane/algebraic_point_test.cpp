// Expansions at branch points compared with closed forms.
#include "libration/plane/algebraic_point.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace plane_algebraic_point_test {

using namespace libration;
using namespace libration::ode;

namespace {

algebraic_point point_of(const std::string& text, std::complex<double> near) {
    const explicit_system system{parse(text)};
    const chart_atlas atlas(system, 2);
    return algebraic_point_near(system, atlas, *uniformizing_chart::of(system), exact_point(near), 12);
}

bool is_narrow(const ball& x) { return certainly_less(radius_of(x), pow(ball(10), -20L)); }

void check_only(const algebraic_point& of, int index, const ball& value) {
    for (int j = -of.pole; j <= of.last(); ++j) {
        INFO("j = " << j);
        CHECK(contains(of.coefficient(j).re, j == index ? value : ball(0)));
        CHECK(contains_zero(of.coefficient(j).im));
        CHECK(is_narrow(of.coefficient(j).re));
        const ball size = abs(of.coefficient(j).re);
        CHECK(certainly_less(size, ball(of.size / pow(of.reach, j + of.pole) * 2)));
    }
}

}  // namespace

// (1 - 2t)^(-1/2), its negative, (1 - 3t)^(-1/3), sqrt(1 - t), (1 - 2t/3)^(1/2)
TEST_CASE("one term of known sign and exponent", "[plane][proved]") {
    const precision_scope scope(60);
    const algebraic_point cubic = point_of("y' = y^3; y(0) = 1", 0.5);
    CHECK(cubic.sheets == 2);
    CHECK(cubic.pole == 1);
    CHECK(contains(cubic.place.re, ball(1) / 2));
    check_only(cubic, -1, ball(1));
    check_only(point_of("y' = y^3; y(0) = -1", 0.5), -1, ball(-1));
    const algebraic_point quartic = point_of("y' = y^4; y(0) = 1", 0.333333);
    CHECK(quartic.sheets == 3);
    check_only(quartic, -1, ball(1));
    check_only(point_of("y' = -1/(2*y); y(0) = 1", 1), 1, ball(1));
    check_only(point_of("y' = 1/(3*y); y(0) = -1", -1.5), 1, ball(-1));
}

// y = sqrt(t^2 + 1) has y y' = t: branch points +-i on which x = sqrt(1 - t/i), y^2 = (1 - t/i)(1 + t/i) = x^2 (2 - x^2).
TEST_CASE("a branch point off the real axis", "[plane][proved]") {
    const precision_scope scope(60);
    const algebraic_point upper = point_of("y' = t/y; y(0) = 1", {0, 1});
    CHECK(contains(upper.place.im, ball(1)));
    CHECK(contains_zero(upper.coefficient(0).re));
    // sqrt 2 (x - x^3/4 - x^5/32 - ..)
    CHECK(contains(upper.coefficient(1).re, sqrt(ball(2))));
    CHECK(contains(upper.coefficient(3).re, -sqrt(ball(2)) / 4));
    CHECK(contains(upper.coefficient(5).re, -sqrt(ball(2)) / 32));
    CHECK(contains_zero(upper.coefficient(2).re));
}

TEST_CASE("equations with and without a uniformizing chart", "[plane][proved]") {
    const auto chart_of = [](const std::string& text) { return uniformizing_chart::of(explicit_system(parse(text))); };
    CHECK_FALSE(chart_of("y' = y^2 + t; y(0) = 1"));
    CHECK_FALSE(chart_of("y' = y/(1 - t); y(0) = 1"));  // a singularity of fixed place
    CHECK_FALSE(chart_of("x'' = -x^3; x(0) = 1; x'(0) = 0"));
    const auto lienard = chart_of("x'' = 2*(1 - x^2)*x' - x; x(0) = 1; x'(0) = 0");
    REQUIRE(lienard);
    CHECK(lienard->sheets() == 2);
    CHECK(lienard->pole() == 1);
    // z = x' - G(x), G = 2x - 2x^3/3
    const auto state = lienard->from(rational(0), std::vector<rational>{2, 5});
    CHECK(state == std::vector<rational>{0, rational(1, 2), 5 - (4 - rational(16, 3))});
}

}  // namespace plane_algebraic_point_test
