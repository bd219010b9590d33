// Theorem K with frames in double, from 50 unknowns on, against a closed form.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_collocation_many_unknowns_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr int points = 49;

// s' = s - s^3, and u_i = s w_i for the solution w_i = exp(-l t) sin(pi i/50) of the heat equation on the points of a
// line, w_i' = 250 (w_(i-1) - 2 w_i + w_(i+1)), l = 500 (1 - cos(pi/50)).
std::string heat_and_growth() {
    std::string text = "s' = s - s^3; s(0) = 1/2";
    for (int i = 1; i <= points; ++i) {
        const auto name = [](int k) { return k == 0 || k > points ? std::string("0") : "u" + std::to_string(k); };
        text += "; " + name(i) + "' = (1 - s^2)*" + name(i) + " + 250*(" + name(i - 1) + " - 2*" + name(i) + " + " +
                name(i + 1) + "); " + name(i) + "(0) = sin(" + std::to_string(i) + "*pi/50)/2";
    }
    return text;
}

}  // namespace

TEST_CASE("fifty stiff unknowns are enclosed by collocation", "[ode][proved]") {
    const precision_scope scope(60);
    proof_route route;
    route.integrator = integrator_choice::collocation;
    proved_march march(explicit_system(parse(heat_and_growth())), 120, {}, proved_march::usual_error_bits, route);
    for (const long tenths : {3L, 20L}) {
        const auto state = march.at(number(rational(tenths, 10)));
        REQUIRE(state);
        const ball t = ball(tenths) / 10L;
        const ball pi = constant_value<ball>::of(parse_constant("pi").constant());
        const ball s = ball(1) / sqrt(ball(1) + exp(t * -2L) * 3L);
        const ball decay = exp(t * 500L * (cos(pi / 50L) - 1L));
        CHECK(contains_zero((*state)[0] - s));
        for (int i = 1; i <= points; ++i) {
            const ball truth = s * decay * sin(pi * static_cast<long>(i) / 50L);
            const ball& found = (*state)[static_cast<std::size_t>(i)];
            CHECK(contains_zero(found - truth));
            CHECK(certainly_less(radius_of(found), truth * pow(ball(10), -15L)));
        }
    }
    CHECK(march.collocation().steps > 0);
    CHECK(march.steps() < 50);
}

}  // namespace integration_collocation_many_unknowns_test
