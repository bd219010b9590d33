// Series of linear equations, also of few terms, compared with closed forms and with Airy's function.
#include "../../src/libration/manifold/linear_series.hpp"

#include <catch2/catch.hpp>

#include "../../src/libration/manifold/regular_solution.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace manifold_linear_series_test {

using namespace libration;
using namespace libration::ode;

// y'' = s y from 1/2: Ai and Ai'.
TEST_CASE("the steps of Airy's equation enclose Airy's function", "[ode][proved]") {
    for (const long digits : {20L, 60L, 200L}) {
        const precision_scope scope(digits);
        const second_order_equation airy{{ball(1)}, {}, {ball(0), ball(1)}};
        ball ai;
        ball slope;
        const ball from = ball(1) / 2;
        arb_hypgeom_airy(ai.handle(), slope.handle(), nullptr, nullptr, from.handle(), ball::working_bits());
        const auto step = second_order_step::towards(airy, from, ball(-3), 8);
        REQUIRE(step);
        const auto solution = step->solution(ai, slope);
        REQUIRE(solution);
        for (const long part : {1L, 3L, 4L}) {
            const ball tau = ball(part) / 4;
            const ball s = from + step->length() * tau;
            ball y;
            ball by_s;
            arb_hypgeom_airy(y.handle(), by_s.handle(), nullptr, nullptr, s.handle(), ball::working_bits());
            CHECK(overlaps(solution->value(tau), y));
            CHECK(overlaps(solution->slope(tau), by_s));
            CHECK(magnitude::radius_of(solution->value(tau)) <= magnitude::of(1, 40 - ball::working_bits()));
        }
    }
}

// (1 + s^2)^2 y'' = y: sqrt(1 + s^2), and the same with a term of y': (1 + s^2) y' = s y, so (1 + s^2) y'' + s y' = y.
TEST_CASE("few terms of a series with singular points enclose the closed form", "[ode][proved]") {
    const precision_scope scope(60);
    const auto exact = [](const ball& s) { return sqrt(s * s + 1); };
    const second_order_equation plain{{ball(1), ball(0), ball(2), ball(0), ball(1)}, {}, {ball(1)}};
    const second_order_equation with_slope{{ball(1), ball(0), ball(1)}, {ball(0), ball(1)}, {ball(1)}};
    for (const second_order_equation& of : {plain, with_slope}) {
        for (const std::size_t terms : {6U, 9U, 14U, 40U}) {
            const ball from(1);
            const auto step = second_order_step::towards(of, from, ball(3), 4);
            REQUIRE(step);
            const auto solution = step->solution(exact(from), from / exact(from), terms);
            REQUIRE(solution);
            const ball to = from + step->length();
            CHECK(contains(solution->value(ball(1)), exact(to)));
            CHECK(contains(solution->slope(ball(1)), to / exact(to)));
        }
    }
}

// theta^2 y = (rho^2 + w) y: y = w^rho 0F1(2 rho + 1; w).
TEST_CASE("few terms of a solution at a regular singular point enclose it", "[ode][proved]") {
    const precision_scope scope(60);
    for (const std::size_t terms : {2U, 3U, 6U, 12U}) {
        const regular_equation of{{ball(2), ball(1)}, {ball(1)}, 0};
        const ball w = ball(1) / 2;
        const auto found = regular_solution_at(of, w, terms);
        REQUIRE(found);
        const ball rho = sqrt(ball(2));
        ball exact;
        ball next;
        const ball b = rho * 2 + 1;
        const ball c = b + 1;
        arb_hypgeom_0f1(exact.handle(), b.handle(), w.handle(), 0, ball::working_bits());
        arb_hypgeom_0f1(next.handle(), c.handle(), w.handle(), 0, ball::working_bits());
        CHECK(contains(found->value, exact));
        CHECK(contains(found->slope, rho * exact + w * next / b));
        CHECK(found->is_positive);
    }
    // (1 - w)^2 (theta^2 - theta) y = 2 w y: w/(1 - w).
    const regular_equation pole{{ball(0), ball(2)}, {ball(1), ball(-2), ball(1)}, 1};
    for (const std::size_t terms : {8U, 40U}) {
        const ball w = ball(1) / 16;
        const auto found = regular_solution_at(pole, w, terms);
        REQUIRE(found);
        CHECK(contains(found->value, ball(1) / (ball(1) - w)));
    }
}

}  // namespace manifold_linear_series_test
