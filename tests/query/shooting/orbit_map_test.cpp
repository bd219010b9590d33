// The map of a periodic orbit compared with closed forms.
#include "../../../src/libration/query/shooting/orbit_map.hpp"

#include <catch2/catch.hpp>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace query_shooting_orbit_map_test {

using namespace libration;
using namespace libration::ode;

// x = cos t: x'(T/2) = -sin(T/2) by the reversal (x, x') -> (x, -x'), x'(T) = -sin T without it.
TEST_CASE("the conditions of a harmonic oscillator and their derivative by the period", "[ode][proved]") {
    const precision_scope scope(40);
    const explicit_system system(parse("x'' = -x; x(0) = 1; x'(0) = 0"));
    const first_order_form form(system);
    for (const bool half : {true, false}) {
        INFO("half " << half);
        const orbit_conditions conditions{.free = {},
                                          .is_period_free = true,
                                          .rows = {1},
                                          .dropped = {},
                                          .integrals = {},
                                          .reversal = half ? std::vector<int>{1, -1} : std::vector<int>()};
        const orbit_map map(system, form, conditions, number(rational(2)), {}, {});
        const auto at = map({ball(2)}, 120, 120);
        REQUIRE(at);
        const ball phase(half ? 1 : 2);
        CHECK(overlaps(at->value[0], ball(-sin(phase))));
        CHECK(overlaps(at->derivative[0][0], ball(half ? -cos(phase) / 2 : -cos(phase))));
        CHECK(certainly_less(radius_of(at->derivative[0][0]), pow(ball(2), -80L)));
    }
}

}  // namespace query_shooting_orbit_map_test
