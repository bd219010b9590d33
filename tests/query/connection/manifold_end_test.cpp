// A point on a manifold, and its derivatives by a parameter and by theta, compared with the closed form of a soliton.
#include "../../../src/libration/query/connection/manifold_end.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/equation/parametric_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace query_connection_manifold_end_test {

using namespace libration;
using namespace libration::ode;

// y'' = k y - y^3: y = x/(1 + x^2/(8 k)) with x = 2 sqrt(2 k) exp(-sqrt(k) t), the coordinate along (1, -sqrt k), k < 1.
TEST_CASE("a manifold with a parameter is enclosed, with its derivatives", "[ode][proved]") {
    const precision_scope scope(40);
    const parametric_system open = opened(parse("y'' = k*y - y^3; y(0) = 1; y'(0) = 0; k = 1/2"), {"k"});
    const first_order_form form(open.system);
    std::vector<std::pair<std::size_t, expression>> known;
    for (std::size_t i = 0; i < form.names.size(); ++i) {
        if (form.names[i] == "k") {
            known.emplace_back(i, open.leaves.front());
        } else if (form.names[i] == "y") {
            known.emplace_back(i, expression(0));
        }
    }
    manifold_end end(form, lifted_about_points(open.system), far_state_of(form, known, 1), open.leaves, 1);
    REQUIRE(end.choose({0.5}, static_cast<std::size_t>(-1)));
    REQUIRE(end.variables() == 1);
    const ball k = widened(ball(1) / 2, magnitude::of(1, -90));
    const ball theta = ball(1) / 3;
    for (const int degree : {12, 20}) {
        const auto found = end.at({k}, {theta}, degree, true);
        REQUIRE(found);
        const ball x = theta * magnitude::of(1, end.plan().log2_scale).exact();
        const ball middle = ball(1) / 2;
        const ball below = ball(1) + x * x / (middle * 8);
        CHECK(contains(found->value[0], x / below));
        CHECK(contains(found->by_numbers[0][0], x * x * x / (middle * middle * 8) / (below * below)));
        const ball slope = (ball(1) - x * x / (middle * 8)) / (below * below);
        CHECK(contains(found->by_theta[0][0], slope * magnitude::of(1, end.plan().log2_scale).exact()));
        CHECK(magnitude::radius_of(found->value[0]).above() < 0.1);
        // y' = -x (1 - x^2/(8 k))/(1 + x^2/(8 k))^2 sqrt k.
        CHECK(contains(found->value[1], -x * sqrt(middle) * slope));
    }
}

// The same at later times, where x = 2^scale theta exp(-t/sqrt 2) for k = 1/2; and s' = -s, v' = -2 v + s^2, where v has a factor t.
TEST_CASE("the motion on a manifold is enclosed where it is linear, and else refused", "[ode][proved]") {
    const precision_scope scope(40);
    const explicit_system system(parse("y'' = y/2 - y^3; y(0) = 1; y'(0) = 0"));
    const first_order_form form(system);
    manifold_end end(form, lifted_about_points(system), far_state_of(form, {{0, expression(0)}}, 1), {}, 1);
    REQUIRE(end.choose({}, static_cast<std::size_t>(-1)));
    const std::vector<ball> times{ball(0), ball(1) / 2, ball(4)};
    const auto found = end.along({}, {ball(1) / 2}, times, 12);
    REQUIRE(found);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const ball x = magnitude::of(1, end.plan().log2_scale).exact() / 2 * exp(-times[i] / sqrt(ball(2)));
        CHECK(contains((*found)[i][0], x / (ball(1) + x * x / 4)));
        CHECK(magnitude::radius_of((*found)[i][0]) < magnitude(x) / 4U);
    }
    const explicit_system other(parse("s' = -s; v' = -2*v + s^2; s(0) = 1; v(0) = 1"));
    const first_order_form resonant(other);
    manifold_end both(resonant, lifted_about_points(other),
                      far_state_of(resonant, {{0, expression(0)}, {1, expression(0)}}, 1), {}, 1);
    REQUIRE(both.choose({}, static_cast<std::size_t>(-1)));
    CHECK_FALSE(both.along({}, {ball(1) / 4, ball(1) / 4}, times, 12));
}

}  // namespace query_connection_manifold_end_test
