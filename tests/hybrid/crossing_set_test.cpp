// Sets of solutions behind an event that resets a value and changes the equations, against the solutions through single
// points in closed form.
#include "libration/hybrid/crossing_set.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace hybrid_crossing_set_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 150;

// x'' = -1 up to x = 0, where x' becomes -3/4 x' + t/8, and x'' = x behind it.
struct falling {
    explicit_system system{parse("x'' = -1; x(0) = 1; x'(0) = 1/4")};
    first_order_form before{system};
    first_order_form after{explicit_system(parse("x'' = x; x(0) = 1; x'(0) = 1/4"))};
    expression g = before.given[0];
    std::vector<expression> reset{before.given[0], before.given[1] * expression(number(rational(-3, 4))) +
                                                       variable() * expression(number(rational(1, 8)))};

    static ball time_of_event(const ball& x, const ball& v) { return v + sqrt(v * v + x * 2); }

    static std::vector<ball> at(const ball& time, const ball& x, const ball& v) {
        const ball event = time_of_event(x, v);
        const ball speed = (v - event) * ball(-3) / 4 + event / 8;
        return {speed * sinh(time - event), speed * cosh(time - event)};
    }

    // The set of the solutions from a box of half-widths w, whose event is assumed in a ball of times.
    std::optional<state_set> behind(const magnitude& w, const ball& times, const ball& begin) const {
        const flow_state start{ball(0), box_around({widened(ball(1), w), widened(ball(1) / 4, w)}, bits), {}, {}};
        integration along(start, rule_for(system, {bits}, {}, error_weights::any_width), ball(4), bits);
        const step* const here = along[0];
        REQUIRE(here != nullptr);
        REQUIRE(here->covers(widened(times, magnitude::radius_of(times))));
        return set_after_crossing(*here, {before, after, reset, &g, times, begin});
    }
};

}  // namespace

TEST_CASE("the set behind an event contains the solution through each of its points", "[hybrid][proved]") {
    const precision_scope scope(60);
    const falling model;
    for (const long exponent : {-7L, -20L, -100L}) {
        CAPTURE(exponent);
        const magnitude w = magnitude::of(1, exponent);
        const ball x = widened(ball(1), w), v = widened(ball(1) / 4, w);
        const ball times = falling::time_of_event(x, v);
        const ball begin = lower_bound(times);
        const auto set = model.behind(w, times, begin);
        REQUIRE(set);
        const auto hull = set->hull();
        const ball width = w.exact();
        for (const int i : {-4, -3, 0, 1, 4}) {
            for (const int j : {-4, -1, 0, 2, 4}) {
                const auto truth = falling::at(begin, ball(1) + width * i / 4, ball(1) / 4 + width * j / 4);
                CHECK(contains(hull[0], truth[0]));
                CHECK(contains(hull[1], truth[1]));
            }
        }
        // The columns: the corners bound the set within a few of its own widths, and a box at `times` would lose more
        // bits, as the solutions cross at different times.
        const auto low = falling::at(begin, ball(1) - width, ball(1) / 4 - width);
        const auto high = falling::at(begin, ball(1) + width, ball(1) / 4 + width);
        for (const std::size_t k : {0U, 1U}) {
            CHECK(certainly_less(radius_of(hull[k]), abs(high[k] - low[k]) * 2));
        }
    }
}

// x' = -1 and y' = 0 up to x = 0, then y' = -y: from there back to the beginning of the times, y grows by exp(w + x - 1).
TEST_CASE("the set behind an event grows by the flow of the next branch", "[hybrid][proved]") {
    const precision_scope scope(60);
    const explicit_system system(parse("x' = -1; y' = 0; x(0) = 1; y(0) = 0"));
    const first_order_form before(system), after(explicit_system(parse("x' = 0; y' = -y; x(0) = 1; y(0) = 0")));
    const ball width = ball(1) / 32;
    const flow_state start{ball(0), box_around({enclose(ball(1), width), enclose(ball(0), width)}, bits), {}, {}};
    integration along(start, rule_for(system, {bits}, {}, error_weights::any_width), ball(4), bits);
    const step* const here = along[0];
    REQUIRE(here != nullptr);
    const ball times = enclose(ball(1), width), begin = lower_bound(times);
    const auto set = set_after_crossing(*here, {before, after, before.given, &before.given[0], times, begin});
    REQUIRE(set);
    for (const int i : {-1, 0, 1}) {
        CHECK(contains(set->hull()[1], width * exp(width * (1 + i))));
        CHECK(contains(set->hull()[1], -width * exp(width * (1 + i))));
    }
    CHECK(certainly_less(radius_of(set->hull()[1]), width * exp(width * 8)));
}

TEST_CASE("there is no set if not every solution crosses in the times", "[hybrid][proved]") {
    const precision_scope scope(60);
    const falling model;
    const magnitude w = magnitude::of(1, -7);
    const ball whole = falling::time_of_event(widened(ball(1), w), widened(ball(1) / 4, w));
    const ball part = widened(midpoint_alone(whole), magnitude::radius_of(whole).shifted(-3));
    CHECK(model.behind(w, whole, lower_bound(whole)));
    CHECK_FALSE(model.behind(w, part, lower_bound(part)));
}

}  // namespace hybrid_crossing_set_test
