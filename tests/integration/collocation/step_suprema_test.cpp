// Suprema over a step by coefficients and by values at nodes, against polynomials whose maxima are known.
#include <catch2/catch.hpp>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/collocation/node_frames.hpp"
#include "libration/integration/collocation/step_suprema.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_collocation_step_suprema_test {

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

// x' = t x + y, y' = -8 y, 0 <= t <= 2, in the time 1 + x: V = ((1 + x/4, 0), (x/8, 1)) and W = 1 + H with
// H = ((-x/4), (-x/8)), a slow and a fast mode. Then W V - 1 = ((-x^2/16, 0), (-x^2/32, 0)), and
//     J V - V' = (((1 + x)(1 + x/4) + x/8 - 1/4, 1), (-x - 1/8, -8)),
// so that W (J V - V') has in the first row (1 - x/4) a, a = 3/4 + 11 x/8 + x^2/4, and 1 - x/4, and in the second
// -a x/8 - x - 1/8 and -x/8 - 8: at most 57/32, 5/4, 91/64 and 65/8, the second at x = -1 and the others at 1.
TEST_CASE("an inverse by a change of its slow columns is bounded over the whole step", "[ode][proved]") {
    const precision_scope scope(60);
    const auto quotient = [](long p, long q) { return ball(p) / ball(q); };
    const moving_frame frame{{{ball(1), quotient(1, 4)}, {}, {ball(0), quotient(1, 8)}, {ball(1)}},
                             {{ball(1)}, {}, {}, {ball(1)}},
                             {1, 1},
                             1,
                             {{ball(0), quotient(-1, 4)}, {ball(0), quotient(-1, 8)}}};
    const tube_candidate found{{ball(0), ball(2)}, {0, 0}, {{ball(0)}, {ball(0)}}, frame};
    const polynomial_map map(lifted(explicit_system(parse("x' = t*x + y; y' = -8*y; x(0) = 0; y(0) = 0"))));
    const auto constants = enclosed_constants(map);
    const step_suprema of = node_suprema(map, constants, bits, bits, bits).of(found);
    const auto is_bound = [](const magnitude& bound, long p, unsigned long q) {
        const magnitude scaled = bound * magnitude(q);
        return magnitude(static_cast<unsigned long>(p)) <= scaled &&
               scaled < magnitude(static_cast<unsigned long>(2 * p + 1));
    };
    CHECK(is_bound(of.unit[0], 1, 16));
    CHECK(is_bound(of.unit[2], 1, 32));
    CHECK(of.unit[1] < magnitude::of(1, -40));
    CHECK(of.unit[3] < magnitude::of(1, -40));
    CHECK(is_bound(of.frame[0], 5, 4));
    CHECK(is_bound(of.frame[2], 1, 8));
    CHECK(is_bound(of.inverse[0], 5, 4));
    CHECK(is_bound(of.inverse[2], 1, 8));
    CHECK(is_bound(of.linear[0], 57, 32));
    CHECK(is_bound(of.linear[1], 5, 4));
    CHECK(is_bound(of.linear[2], 91, 64));
    CHECK(is_bound(of.linear[3], 65, 8));
    REQUIRE(of.rates.size() == 2);
    CHECK(!certainly_less(of.rates[1], quotient(-63, 8)));
    CHECK(certainly_less(of.rates[1], quotient(-62, 8)));
}

// With a = 1 + 2^-52, J = ((a, 1), (0, 0)) and the fast column (a, -1 - 2^-51): a^2 - 1 - 2^-51 = 2^-104, which is 0 in double.
TEST_CASE("a sum of products with a frame that is lost in double is enclosed", "[ode][proved]") {
    const precision_scope scope(100);
    const auto with_power = [](long m, long e) { return ball(1) + ball(m) * pow(ball(2), e); };
    const moving_frame frame{{{ball(1)}, {with_power(1, -52)}, {}, {-with_power(1, -51)}},
                             {{ball(1)}, {}, {}, {ball(1)}},
                             {1, 1},
                             1,
                             {{}, {}}};
    const chebyshev_zeros zeros(1, 1, bits);
    const std::vector<std::pair<std::size_t, std::size_t>> places{{0, 0}, {0, 1}};
    const std::vector<ball> entries{with_power(1, -52), ball(1)};
    for (const auto& frames : {frames_in_double(frame, zeros, bits), frames_in_balls(frame, zeros, bits, bits)}) {
        const node_frame at = frames->at(3, {places, entries});
        CHECK(arb_contains(at.linear(0, 1).handle(), pow(ball(2), -104L).handle()) != 0);
        CHECK(certainly_less(radius_of(at.linear(0, 1)), pow(ball(2), -48L)));
    }
}

// In the basis V = ((1, 1), (0, 1)), J = ((-3, 0), (0, -5)) becomes ((-3, 2), (0, -5)).
TEST_CASE("a frame in double without slow modes is that of its basis", "[ode][proved]") {
    const precision_scope scope(60);
    const moving_frame frame{{{ball(1)}, {ball(1)}, {}, {ball(1)}}, {{ball(1)}, {ball(-1)}, {}, {ball(1)}}, {1, 1}, 0};
    const chebyshev_zeros zeros(1, 1, bits);
    const std::vector<std::pair<std::size_t, std::size_t>> places{{0, 0}, {1, 1}};
    const std::vector<ball> entries{ball(-3), ball(-5)};
    const node_frame at = frames_in_double(frame, zeros, bits)->at(0, {places, entries});
    const std::vector<long> truth{-3, 2, 0, -5};
    for (std::size_t i = 0; i < truth.size(); ++i) {
        CHECK(arb_contains_si(at.linear.entries[i].handle(), truth[i]) != 0);
        CHECK(certainly_less(radius_of(at.linear.entries[i]), pow(ball(2), -45L)));
        CHECK(contains_zero(at.unit.entries[i]));
        CHECK(certainly_less(radius_of(at.unit.entries[i]), pow(ball(2), -45L)));
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

}  // namespace integration_collocation_step_suprema_test
