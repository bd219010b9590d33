// The graph of solutions that tend to a saddle with 1/t in the equation, compared with solutions in closed form.
#include "../../src/libration/manifold/saddle_graph.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace manifold_saddle_graph_test {

using namespace libration;
using namespace libration::ode;

namespace {

struct far_solution {
    ball u, v;
};

// Whether the graph about a solution contains it, and with which error relative to its deviation s.
double error_about(const saddle_equation& of, long t, std::size_t terms, const far_solution& at) {
    const auto formal = formal_saddle_graph(of, terms);
    REQUIRE(formal);
    const ball w = ball(1) / ball(t);
    const magnitude s(formal->place_of(at.u, at.v, w).s);
    const auto graph = proved_saddle_graph(of, *formal, magnitude(w), s.shifted(1));
    REQUIRE(graph);
    const auto place = graph->place_of(at.u, at.v, w);
    CHECK(contains_zero(widened(place.rho, graph->eps)));
    CHECK_FALSE(contains_zero(place.rho));
    return (graph->eps / s).above();
}

ball bessel_k(long order, const ball& x) {
    ball result;
    arb_hypgeom_bessel_k(result.handle(), ball(order).handle(), x.handle(), ball::working_bits());
    return result;
}

// c w^i u^j v^k.
saddle_equation::term term_of(long c, unsigned w, unsigned u, unsigned v) { return {ball(c), w, u, v}; }

}  // namespace

// u'' + u'/t = u: K_0(t), whose series in 1/t diverges.
TEST_CASE("the graph of a linear equation in the plane contains a Bessel function", "[ode][proved]") {
    const precision_scope scope(60);
    const saddle_equation plane{{term_of(1, 0, 1, 0), term_of(-1, 1, 0, 1)}, ball(0)};
    double last = 1;
    for (const long t : {6L, 9L, 12L}) {
        const double error =
            error_about(plane, t, static_cast<std::size_t>(2 * t), {bessel_k(0, ball(t)), -bessel_k(1, ball(t))});
        CHECK(error < last / 50);  // like exp(-2 t)
        last = error;
    }
    CHECK(last < 1e-9);
}

// u = 1/t + sech^2((t - 1)/2): a far field that is not constant, and all powers of the deviation.
TEST_CASE("the graph next to a moving far field contains a soliton", "[ode][proved]") {
    const precision_scope scope(60);
    // u'' = 2 w^3 + y - 3/2 y^2, y = u - w.
    const saddle_equation moving{{term_of(2, 3, 0, 0),
                                  term_of(1, 0, 1, 0),
                                  term_of(-1, 1, 0, 0),
                                  {ball(-3) / 2, 0, 2, 0},
                                  term_of(3, 1, 1, 0),
                                  {ball(-3) / 2, 2, 0, 0}},
                                 ball(0)};
    for (const long t : {12L, 16L}) {
        const ball c = ball(1) / cosh(ball(t - 1) / 2);
        const ball y = c * c;
        const ball slope = -y * tanh(ball(t - 1) / 2);
        CHECK(error_about(moving, t, static_cast<std::size_t>(t), {y + ball(1) / t, slope - ball(1) / (t * t)}) < 1);
    }
}

TEST_CASE("no graph is proved near t = 0, nor without a saddle", "[ode][proved]") {
    const precision_scope scope(60);
    const saddle_equation plane{{term_of(1, 0, 1, 0), term_of(-1, 1, 0, 1)}, ball(0)};
    const auto formal = formal_saddle_graph(plane, 8);
    REQUIRE(formal);
    CHECK_FALSE(proved_saddle_graph(plane, *formal, magnitude(2U), magnitude::of(1, -20)));
    CHECK_FALSE(formal_saddle_graph({{term_of(-1, 0, 1, 0)}, ball(0)}, 8));
}

}  // namespace manifold_saddle_graph_test
