// Singularities of several unknowns, and poles whose order is not proved, against closed forms.
#include "libration/plane/proved_singularity.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace plane_proved_singularity_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

ball squared_modulus(const complex_ball& z) { return z.re * z.re + z.im * z.im; }

}  // namespace

// x = 1/(1 - t) and y = -log(1 - t), whose integral along a loop about 1 from s is 2 pi i (s - 1), up to its sign.
TEST_CASE("singularities are proved for the unknowns that they were found for", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    auto found = singularities_of(typed("x' = x^2; x(0) = 1"), {.within = 2, .digits = 20}).all;
    REQUIRE(found.size() == 1);
    found.push_back(found.front());
    found[0].unknown = 0;
    found[1].unknown = 1;
    const auto proved = prove_singularities(typed("y' = x; x' = x^2; y(0) = 0; x(0) = 1"), found, 10);
    REQUIRE(proved.size() == 2);
    CHECK(proved[0].refusal.empty());
    CHECK(proved[0].evidence.unknown == 0);
    CHECK(proved[0].evidence.power == 0);
    const complex_ball radius = proved[0].evidence.polygon.front() - complex_ball(1);
    const ball turn = pi<ball>() * 2;
    CHECK(overlaps(squared_modulus(proved[0].evidence.value), turn * turn * squared_modulus(radius)));
    CHECK(proved[1].refusal.empty());
    CHECK(proved[1].evidence.unknown == 1);
    CHECK(overlaps(squared_modulus(proved[1].evidence.value), turn * turn));
    CHECK(proved[1].pole_order == 1);
}

// y = t/(1 - t): half way from -1 to the pole at 1 lies its zero, where 1/y has no value with any number of bits.
TEST_CASE("a pole is proved without its order where regular coordinates have no value", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    const explicit_system system = typed("y' = (1 + y)^2; y(0) = 0");
    auto found = singularities_of(system, {.within = 2, .digits = 20}).all.front();
    CHECK(prove_singularity(system, found, mpfr("1e-10")).pole_order == 1);
    found.offset = {mpfr(1), mpfr(0)};
    found.path = {{-1, 0}};
    CHECK(prove_singularity(system, found, mpfr("1e-10")).pole_order == 0);
}

namespace {

// Throws an error of this kind at step number `last` of this kind, counted in `steps`.
proof_route ended_route(long& steps, plane_step of, long last, error_kind kind) {
    proof_route route;
    route.watch = [&steps, of, last, kind](plane_step step) {
        steps += step == of ? 1 : 0;
        if (steps == last) {
            throw error(kind, "work", "", "was ended");
        }
    };
    return route;
}

}  // namespace

TEST_CASE("singularities without a proof have the reason", "[ode][proved][singularity]") {
    const explicit_system system = typed("y' = y^2; y(0) = 1");
    auto found = singularities_of(system, {.within = 2, .digits = 20}).all;
    long steps = 0;
    const auto ended =
        prove_singularities(system, found, 10, {}, ended_route(steps, plane_step::disc, 1, error_kind::undecided));
    CHECK(ended.front().refusal == "was not decided: work was ended");
    steps = 0;
    CHECK_THROWS_WITH(
        prove_singularities(system, found, 10, {}, ended_route(steps, plane_step::disc, 1, error_kind::argument)),
        "work was ended");
    found.front().offset.re += mpfr("0.25");
    CHECK(prove_singularities(system, found, 10).front().refusal.find("no change or integral") != std::string::npos);
}

TEST_CASE("a proof of a radius that is ended passes the reason on, with the bounds so far",
          "[ode][proved][singularity]") {
    const explicit_system system = typed("y' = y^2; y(0) = 1");
    long steps = 0;
    CHECK_THROWS_WITH(prove_radius(system, 3, ended_route(steps, plane_step::point, 1, error_kind::undecided)),
                      "work was ended");
    // The last point is a singularity of the map, whose position is refined after the search.
    steps = 0;
    prove_radius(system, 3, ended_route(steps, plane_step::point, -1, error_kind::undecided));
    const long points = steps;
    steps = 0;
    CHECK_THROWS_WITH(prove_radius(system, 3, ended_route(steps, plane_step::point, points, error_kind::undecided)),
                      "work was ended");
    steps = 0;
    prove_radius(system, 3, ended_route(steps, plane_step::disc, -1, error_kind::undecided));
    const long discs = steps;
    steps = 0;
    CHECK_THROWS_WITH(prove_radius(system, 3, ended_route(steps, plane_step::disc, discs, error_kind::undecided)),
                      Catch::Contains("proved; a lower bound is not: work was ended"));
    steps = 0;
    CHECK_THROWS_WITH(prove_radius(system, 3, ended_route(steps, plane_step::disc, discs, error_kind::argument)),
                      "work was ended");
}

}  // namespace plane_proved_singularity_test
