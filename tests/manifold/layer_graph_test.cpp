// The graph of decaying solutions of boundary layers compared with repeated integrals of the error function.
#include "../../src/libration/manifold/layer_graph.hpp"

#include <catch2/catch.hpp>

#include "../../src/libration/algebra/dense_matrix.hpp"
#include "libration/number/exact_real.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace manifold_layer_graph_test {

using namespace libration;
using namespace libration::ode;

namespace {

ball erfc_of(const ball& x) {
    ball result;
    arb_hypgeom_erfc(result.handle(), x.handle(), ball::working_bits());
    return result;
}

}  // namespace

// As u -> 0, f = t and u'' + t u' = 0: u = erfc(t/sqrt 2), r = u'/(t u) = -sqrt(2/pi) exp(-t^2/2)/(t erfc(t/sqrt 2)).
TEST_CASE("the graph of Blasius's layer tends to that of the error function", "[ode][proved]") {
    const precision_scope scope(60);
    const layer_equation blasius{ball(1), ball(1), {}};
    double last = 1;
    for (const long t : {6L, 8L, 10L}) {
        const ball sigma = ball(1) / ball(t * t);
        const auto graph =
            proved_layer_graph(blasius, static_cast<std::size_t>(t * t / 2), magnitude(sigma), magnitude::of(1, -60));
        REQUIRE(graph);
        const ball argument = ball(t) / sqrt(ball(2));
        const ball r = -sqrt(ball(2) / pi<ball>()) * exp(-argument * argument) / (erfc_of(argument) * t);
        const ball enclosure = widened(graph->phi.value(sigma, ball(0)), graph->eps);
        CHECK(contains(enclosure, r));
        CHECK(graph->eps.above() < last / 100);  // like exp(-t^2/2)
        last = graph->eps.above();
    }
    CHECK(last < 1e-19);
}

// f''' + f f'' - 2 b .. with k = const: u'' + t u' = k u has u = i^n erfc with k = n: i^1 erfc(x) = exp(-x^2)/sqrt pi - x erfc x.
TEST_CASE("the graph with a constant factor is that of the first repeated integral", "[ode][proved]") {
    const precision_scope scope(60);
    const layer_equation magnetic{ball(1), ball(1), {ball(1)}};
    const ball sigma = ball(1) / ball(64);
    const auto graph = proved_layer_graph(magnetic, 32, magnitude(sigma), magnitude::of(1, -60));
    REQUIRE(graph);
    const ball x = ball(8) / sqrt(ball(2));
    const ball integral = exp(-x * x) / sqrt(pi<ball>()) - x * erfc_of(x);
    const ball slope = -erfc_of(x) / sqrt(ball(2));
    CHECK(contains(widened(graph->phi.value(sigma, ball(0)), graph->eps), slope / (integral * 8)));
}

TEST_CASE("no graph is proved where the layer is not far away", "[ode][proved]") {
    const precision_scope scope(40);
    const layer_equation blasius{ball(1), ball(1), {}};
    CHECK_FALSE(proved_layer_graph(blasius, 5, magnitude(2U), magnitude::of(1, -10)));
    CHECK_FALSE(proved_layer_graph(blasius, 5, magnitude::of(1, -6), magnitude(1U)));
}

}  // namespace manifold_layer_graph_test
