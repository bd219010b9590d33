// Poles of closed forms, found without a search, and places that must stay undecided.
#include "libration/plane/enclosed_poles.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/constants.hpp"
#include "proved.hpp"

namespace plane_enclosed_poles_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

}  // namespace

TEST_CASE("all poles of the tangent within 8, with residue -1", "[plane][proved]") {
    const precision_scope scope(40);
    const explicit_system system = typed("y' = 1 + y^2; y(0) = 0");
    const chart_atlas atlas(system, 1.1);
    const charted_covering covering(system, atlas, {.rho = 8});
    const auto boxes = enclosed_poles(atlas, covering, 8);
    int inside = 0;
    for (const pole_box& each : boxes) {
        const pole_terms terms = terms_of_pole(system, atlas, each);
        CHECK(terms.real);
        const ball turns = terms.place.re / pi<ball>() - ball(1) / 2;
        CHECK(contains(turns, ball(static_cast<long>(std::lround(midpoint_of(turns).convert_to<double>())))));
        CHECK(contains(terms.principal.front().re, ball(-1)));
        CHECK(certainly_less(radius_of(terms.place.re), pow(ball(10), -30L)));
        inside += std::abs(each.centre) < 8 ? 1 : 0;
    }
    CHECK(inside == 6);
}

// (1 - t)^-2 and 1/(1 + t^2).
TEST_CASE("double poles and pairs", "[plane][proved]") {
    const precision_scope scope(40);
    const explicit_system square = typed("y'' = 6*y^2; y(0) = 1; y'(0) = 2");
    const chart_atlas atlas(square, 2);
    const charted_covering covering(square, atlas, {.rho = 2});
    const auto boxes = enclosed_poles(atlas, covering, 2);
    REQUIRE(boxes.size() == 1);
    const pole_terms terms = terms_of_pole(square, atlas, boxes.front());
    CHECK(contains(terms.place.re, ball(1)));
    REQUIRE(terms.principal.size() == 2);
    CHECK((is_exact(terms.principal[0].re) && contains_zero(terms.principal[0].re)));
    CHECK(contains(terms.principal[1].re, ball(1)));
    const explicit_system pair = typed("y' = -2*t*y^2; y(0) = 1");
    const chart_atlas of_pair(pair, 1.2);
    const charted_covering around(pair, of_pair, {.rho = 2});
    const auto found = enclosed_poles(of_pair, around, 2);
    REQUIRE(found.size() == 1);
    CHECK_FALSE(found.front().real);
    const pole_terms upper = terms_of_pole(pair, of_pair, found.front());
    CHECK(contains(upper.place.im, ball(1)));
    CHECK(contains_zero(upper.place.re));
    CHECK(contains(upper.principal.front().im, ball(-1) / 2));
}

}  // namespace plane_enclosed_poles_test
