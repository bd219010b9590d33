// Suprema over a step by coefficients and by values at nodes, against polynomials whose maxima are known.
#include <catch2/catch.hpp>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/rigorous/step_suprema.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace ode_proved_step_suprema_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 200;

std::vector<ball> enclosed_constants(const polynomial_map& map) {
    std::vector<ball> result;
    for (const number& each : map.constants()) {
        result.push_back(constant_value<ball>::of(each));
    }
    return result;
}

// T_10, of which the zeros of T_16 miss each maximum.
ball_polynomial chebyshev_10() {
    std::vector<ball> coefficients(11);
    coefficients[10] = ball(1);
    return chebyshev_form::in_powers(coefficients);
}

struct by_both_rules {
    step_suprema coefficients, nodes;
};

by_both_rules suprema(const char* system, const tube_candidate& found) {
    const auto form = lifted(explicit_system(parse(system)));
    const polynomial_map map(form);
    const auto constants = enclosed_constants(map);
    return {coefficient_suprema(map, constants, bits, bits).of(found),
            node_suprema(map, constants, bits, bits, bits).of(found)};
}

}  // namespace

// At -1 and 1 |p| = 1, p' = -100 and 100, and f = 1 for a step of the length 2; in between both are smaller.
TEST_CASE("a supremum over a step is at least the maximum between the nodes", "[ode][proved]") {
    const precision_scope scope(60);
    const tube_candidate found{{ball(0), ball(2)}, {0}, {chebyshev_10()}, {{{ball(1)}}, {{ball(1)}}, {1}, 1}};
    const auto [coefficients, nodes] = suprema("x' = 1; x(0) = 0", found);
    CHECK(magnitude(1U) <= coefficients.curve[0]);
    CHECK(magnitude(1U) <= nodes.curve[0]);
    CHECK(nodes.curve[0] < magnitude(2U));
    CHECK(magnitude(101U) <= coefficients.defect[0]);
    CHECK(magnitude(101U) <= nodes.defect[0]);
    CHECK(nodes.defect[0] < magnitude(202U));
}

// V = 1, W = 1 + T_10/8: W V - 1 has the supremum 1/8, and W J = 1000 (3 + x) W, 2 <= t <= 4, is largest at x = 1: 36000/8.
TEST_CASE("products with frames are bounded over the whole step", "[ode][proved]") {
    const precision_scope scope(60);
    ball_polynomial inverse = chebyshev_10();
    for (ball& each : inverse) {
        each /= 8L;
    }
    inverse[0] += 1L;
    const tube_candidate found{{ball(2), ball(2)}, {0}, {{ball(0)}}, {{{ball(1)}}, {inverse}, {1}, 1}};
    const auto [coefficients, nodes] = suprema("x' = 1000*t*x - 1000*t; x(2) = 0", found);
    for (const step_suprema* each : {&coefficients, &nodes}) {
        CHECK(magnitude(1U) <= each->unit[0].shifted(3));
        CHECK(each->unit[0].shifted(3) < magnitude(2U));
        CHECK(magnitude(36'000U) <= each->linear[0].shifted(3));
        CHECK(each->linear[0].shifted(3) < magnitude(72'000U));
        CHECK(magnitude(9U) <= each->inverse[0].shifted(3));
    }
}

// The rate -(1000 + 500 t)/2 of a fast mode, 0 <= t <= 1, is largest at the beginning.
TEST_CASE("the rate of a fast mode is bounded from above with its sign", "[ode][proved]") {
    const precision_scope scope(60);
    const tube_candidate found{{ball(0), ball(1)}, {0}, {{ball(0)}}, {{{ball(1)}}, {{ball(1)}}, {1}, 0}};
    const auto [coefficients, nodes] = suprema("x' = -(1000 + 500*t)*x; x(0) = 0", found);
    for (const step_suprema* each : {&coefficients, &nodes}) {
        CHECK(!certainly_less(each->rates[0], ball(-500)));
        CHECK(certainly_less(each->rates[0], ball(-499)));
    }
}

// x' = -x/2 + 4 y, y' = -3 x/2 - y in one block: the symmetric part has the eigenvalues -3/4 -+ sqrt(1/16 + 25/16).
TEST_CASE("the rate of a pair of modes is that of its symmetric part", "[ode][proved]") {
    const precision_scope scope(60);
    const std::vector<ball_polynomial> unit{{ball(1)}, {}, {}, {ball(1)}};
    const tube_candidate found{{ball(0), ball(2)}, {0, 0}, {{ball(0)}, {ball(0)}}, {unit, unit, {2}, 0}};
    const auto [coefficients, nodes] = suprema("x' = -x/2 + 4*y; y' = -3/2*x - y; x(0) = 0; y(0) = 0", found);
    const ball truth = (sqrt(ball(26)) - 3L) / 4L;
    for (const step_suprema* each : {&coefficients, &nodes}) {
        CHECK(!certainly_less(each->rates[0], truth));
        CHECK(certainly_less(each->rates[0], truth + ball(1) / 1000L));
    }
}

}  // namespace ode_proved_step_suprema_test
