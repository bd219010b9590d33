#include "libration/pendulum/stable_pade_poles.hpp"

#include <catch2/catch.hpp>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_pade_poles_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("Pade poles find the first singularity in every scalar", "[pendulum][pade_poles]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "2.02", "4"}) {
        const motion m = with_energy(energy);
        const auto lattice = *singularities<T>(m);
        const auto found = poles_of_speed<T>(m, 16, epsilon<T>());
        INFO("E = " << energy);
        REQUIRE(found);
        const auto distance = distance_from_first(*found, lattice);
        REQUIRE(distance);
        CHECK(*distance < T(1) / 50);  // 7e-3 at E = 2.02, where it is largest
        for (const auto& pole : found->poles) {
            CHECK(pole.time.re >= 0);
            CHECK(pole.time.im >= 0);
        }
    }
}

TEST_CASE("poles are stable to the digits asked for", "[pendulum][pade_poles]") {
    const motion m = with_energy("1.71");
    const auto few = stable_pade_poles(m, 40, 20);
    const auto many = stable_pade_poles(m, 40, 60);
    const precision_scope scope(100);
    CHECK(same_poles(few, many, 18));
    CHECK(few.numerator_degree + few.denominator_degree + 1 == 20);  // the even powers from 2 to 40
}

TEST_CASE("at E = 1 the next approximant that exists is taken", "[pendulum][pade_poles]") {
    // omega/t is a series in t^4 there: [4/5] does not exist, [5/4] is one in s^2.
    const auto found = stable_pade_poles(with_energy("1"), 20, 30);
    CHECK(found.denominator_degree == 4);
    CHECK(found.poles.size() == 2);
    CHECK(stable_pade_poles(with_energy("1"), 5, 30).poles.empty());
}

TEST_CASE("the lattice is listed as far as the rectangle reaches", "[pendulum][lattice_points]") {
    const singularity_lattice<double> lattice{2, 3};
    const auto points = lattice_points(lattice, 6.0, 5.0);
    REQUIRE(points.size() == 8);  // +-2, +-6 by +-3
    CHECK(points.front().re == -6);
    CHECK(points.front().im == -3);
    CHECK(points.back().re == 6);
    CHECK(points.back().im == 3);
    const auto nearest = nearest_singularity(lattice, complex_number<double>{4.5, 0.1});
    CHECK(nearest.re == 6);
    CHECK(nearest.im == 3);
    CHECK(nearest_singularity(lattice, complex_number<double>{0, 100}).im == 99);
}

}  // namespace pendulum_pade_poles_test
