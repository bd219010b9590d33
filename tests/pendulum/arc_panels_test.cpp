#include "libration/pendulum/arc_panels.hpp"

#include "libration/approximant/difference_norm.hpp"
#include "scalars.hpp"

namespace pendulum_arc_panels_test {

using namespace libration;
using namespace libration::pendulum;
using libration::tests::near;

TEST_CASE("the panels of an arc hold theta and its slope as Jacobi's functions give them", "[arc_panels]") {
    const precision_scope scope(60);
    const auto points = chebyshev_points(301);
    const std::vector<motion> motions{motion::of_energy(rational(1, 2)), motion::of_energy(rational(171, 100)),
                                      motion::of_energy(rational(4), -1),
                                      // T*/K~' is 8 with 130 panels, most of them without enough points.
                                      motion::of_energy(rational(2) - rational(1, integer("10000000000"))),
                                      motion::of_energy(rational(1, 1'000'000))};
    for (const motion& m : motions) {
        const fundamental_arc<mpfr> arc(m);
        const exact_solution<mpfr> solution(m);
        arc_panels panels(arc);
        const auto jets = panels.jets(points);
        const auto values = panels.values(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            INFO("E = " << to_decimal(arc.level().pair.energy, 12) << ", x = " << points[i]);
            const auto state = solution.from_top(mpfr(points[i]));
            const bool mirrored = m.regime() == regime::rotation && m.direction() < 0;
            const mpfr theta = mirrored ? mpfr(pi<mpfr>() * 2 - state.theta) : state.theta;
            const mpfr slope = state.omega * arc.effective_period() * (mirrored ? -1 : 1);
            // Both round theta, at most 2 pi, a few times; the slope is at most 25 and rounds n times in the power n.
            CHECK_THAT(jets[i].value, near(theta, 64, mpfr(1)));
            CHECK_THAT(jets[i].slope, near(slope, 4096, mpfr(1)));
            CHECK(values[i] == jets[i].value);
            CHECK(panels.at(mpfr(points[i])).value == values[i]);
        }
    }
}

}  // namespace pendulum_arc_panels_test
