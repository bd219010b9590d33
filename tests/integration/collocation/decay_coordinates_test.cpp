// Unknowns that decay to nothing: closed forms at times where they are far below the range of double, sets in other
// coordinates, and equations that have none.
#include "libration/integration/collocation/decay_coordinates.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_collocation_decay_coordinates_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

// Whether the ball contains the number, and is narrower than 10^-digits of it.
bool encloses(const ball& found, const ball& truth, long digits) {
    const ball most = abs(truth) * pow(ball(10), -digits);
    return contains_zero(found - truth) && certainly_less(radius_of(found), most);
}

// Of three unknowns, the first two of which decay.
state_set set_of(std::vector<magnitude> radii, std::vector<magnitude> added) {
    const ball part = pow(ball(2), -20L);
    return {{ball(-3) / 4L, ball(5) / 8L, ball(2)},
            lohner_set({{ball(1), ball(0), ball(1)}, {ball(1), ball(1), ball(0)}, {ball(0), part, part}}, {1, 1, 1},
                       std::move(radii), std::move(added))};
}

state_set some_set() {
    return set_of({magnitude::of(1, -12), magnitude::of(1, -13), magnitude::of(1, -4)},
                  {magnitude::of(1, -14), magnitude(), magnitude()});
}

// The curvature of the coordinates is not small in it.
state_set wide_set() {
    return set_of({magnitude::of(1, -4), magnitude::of(1, -5), magnitude()}, {magnitude(), magnitude(), magnitude()});
}

}  // namespace

// u = 1/(1+t); v tends to u^2 like exp(-1e8 t); x = -exp(-t)/(1+t), w = x u, z = u + x.
TEST_CASE("unknowns that decay together keep their digits at any size", "[ode][proved]") {
    const precision_scope scope(80);
    proved_march march(system_of("u' = -u^2; v' = -1e8*(v - u^2) - 2*u^3; x' = -x*(1 + u); w' = -w*(1 + u) - x*u^2; "
                                 "z' = -u^2 - x*(1 + u); u(0) = 1; v(0) = 1; x(0) = -1; w(0) = -1; z(0) = 0"),
                       120);
    for (const long time : {100L, 100'000L}) {
        const auto state = march.at(number(rational(time)));
        REQUIRE(state);
        const ball u = ball(1) / (ball(1) + ball(time));
        const ball x = -exp(ball(-time)) * u;
        CHECK(encloses((*state)[0], u, 15));
        CHECK(encloses((*state)[1], u * u, 15));
        CHECK(encloses((*state)[2], x, 15));
        CHECK(encloses((*state)[3], x * u, 15));
        CHECK(encloses((*state)[4], u + x, 15));
    }
    CHECK(march.collocation().last == 100'000);
    CHECK(march.collocation().steps < 100);  // with a decay by at most 10^-5 per step more than 8,000
}

TEST_CASE("a set in coordinates of decay contains its points, and returns to a set that does", "[ode][proved]") {
    const precision_scope scope(60);
    const auto form = lifted(system_of("w' = -2*w; x' = -x*y + w; y' = x + y; w(0) = 1; x(0) = 1; y(0) = 1"));
    const bool wide = GENERATE(false, true);
    const state_set set = wide ? wide_set() : some_set();
    const auto coordinates = decay_coordinates::of(form, {0, 1}, set);
    REQUIRE(coordinates);
    const ball time(0);
    const auto there = coordinates->to_coordinates().image(time, set);
    REQUIRE(there);
    const auto back = coordinates->from_coordinates().image(time, *there);
    REQUIRE(back);
    for (const long a : {-1L, 1L}) {
        for (const long b : {-1L, 0L, 1L}) {
            std::vector<ball> state;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& columns = set.errors.columns();
                const auto& radii = set.errors.radii();
                state.push_back(set.centre[i] + columns[0][i] * radii[0].exact() * a +
                                columns[1][i] * radii[1].exact() * b + columns[2][i] * radii[2].exact() * a);
            }
            const std::vector<ball> truth{log(-state[0]), state[1] / state[0], state[2]};
            const auto by_map = coordinates->to_coordinates().at(time, state);
            for (std::size_t i = 0; i < 3; ++i) {
                CHECK(overlaps(by_map[i], truth[i]));
                CHECK(arb_contains(there->hull()[i].handle(), truth[i].handle()) != 0);
                CHECK(arb_contains(back->hull()[i].handle(), state[i].handle()) != 0);
                CHECK((wide || certainly_less(radius_of(back->hull()[i]), radius_of(set.hull()[i]) * 3L)));
            }
        }
    }
}

TEST_CASE("there are no coordinates of decay where the equations are not linear in the unknowns", "[ode][proved]") {
    const precision_scope scope(30);
    const auto coordinates_of = [&](const std::string& x, const state_set& at) {
        const auto form = lifted(system_of("w' = -2*w; " + x + "; y' = x + y; w(0) = 1; x(0) = 1; y(0) = 1"));
        return decay_coordinates::of(form, {0, 1}, at).has_value();
    };
    CHECK(coordinates_of("x' = -x*exp(y) + w/(2 + sin(t))", some_set()));
    CHECK_FALSE(coordinates_of("x' = -x^2", some_set()));
    CHECK_FALSE(coordinates_of("x' = -x + y", some_set()));
    CHECK_FALSE(coordinates_of("x' = -x*w", some_set()));
    CHECK_FALSE(coordinates_of("x' = -x", {{ball(0), ball(0), ball(1)}, some_set().errors}));
}

}  // namespace integration_collocation_decay_coordinates_test
