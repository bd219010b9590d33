#include "libration/pendulum/known_arc_series.hpp"

#include <catch2/catch.hpp>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_known_descent_series_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("the pendulum's series is told with its radius, position and number of singularities",
          "[pendulum][known_descent_series]") {
    const precision_scope scope(60);
    // At E = 4 the bottom radius is T* = K(m = 1/2)/sqrt 2, mpmath's ellipk(mpf(1)/2)/sqrt(2); the four about the
    // top lie on the diagonals.
    const auto bottom = known_arc_series("bottom", motion::of_energy(4), 1);
    CHECK_THAT(*bottom.radius, near<mpfr>(decimal("1.311028777146059905232419794945559706841"), 8));
    CHECK_THAT(bottom.position->re, near<mpfr>(mpfr(0), 8, mpfr(1)));
    CHECK(bottom.count == 2);
    const auto top = known_arc_series("top", motion::of_energy(4), 0);
    CHECK_THAT(*top.radius, near<mpfr>(mpfr(*bottom.radius * sqrt(mpfr(2))), 8));
    CHECK_THAT(top.position->re, near<mpfr>(top.position->im, 8));
    CHECK(top.count == 4);
    CHECK(top.kind == singularity_kind::logarithm);
    // a_1 = sqrt(2E) and a_3 = -a_1/6 about the bottom, from theta'' = -sin theta.
    const auto a = bottom.expand(5);
    CHECK(a[2] == 0);
    CHECK_THAT(a[1], near<mpfr>(mpfr(sqrt(mpfr(8))), 16));
    CHECK_THAT(a[3], near<mpfr>(mpfr(-a[1] / 6), 16));
    CHECK_THROWS_AS(known_arc_series("separatrix", motion::of_energy(2), 1).expand(3), libration::error);
}

}  // namespace pendulum_known_descent_series_test
