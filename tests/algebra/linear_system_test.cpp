#include "libration/algebra/linear_system.hpp"

#include <catch2/catch.hpp>

namespace series_linear_system_test {

using namespace libration;

TEST_CASE("linear systems need their pivots", "[series][linear_system]") {
    // x + y = 3, 1e-20 scaled: 1e-20 x - 1e-20 y = -1e-20, and a zero in the first place.
    const auto x = *solve_linear<double>({{0, 1, 1}, {1e-20, -1e-20, 0}, {1, 1, 1}}, {5, -1e-20, 6}, 1e-14);
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(2));
    CHECK(x[2] == Approx(3));
    CHECK_FALSE(solve_linear<double>({{1, 2}, {2, 4}}, {1, 2}, 1e-14));
    CHECK_FALSE(solve_linear<double>({{0, 0}, {2, 4}}, {1, 2}, 1e-14));
    CHECK(solve_linear<double>({}, {}, 1e-14)->empty());
}

TEST_CASE("a growing system solves what its equations share once", "[series][linear_system]") {
    growing_system<double> system(3, 1e-14);
    REQUIRE(system.add({0, 1, 1, 5}));
    REQUIRE(system.add({1e-20, -1e-20, 0, -1e-20}));
    CHECK_FALSE(system.solution());
    REQUIRE(system.add({1, 1, 1, 6}));
    CHECK_FALSE(system.add({1, 0, 0, 1}));  // as many as unknowns already
    const auto x = *system.solution();
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(2));
    CHECK(x[2] == Approx(3));
    // Back to the first two, x = y - 1 and y + z = 5, with another third: z = 1.
    system.keep(2);
    CHECK_FALSE(system.add({1e-20, 1e-20, 2e-20, 9e-20}));  // twice the first and the second
    REQUIRE(system.add({0, 0, 1, 1}));
    const auto y = *system.solution();
    CHECK(y[0] == Approx(3));
    CHECK(y[1] == Approx(4));
    CHECK(y[2] == Approx(1));
    CHECK(growing_system<double>(0, 1e-14).solution()->empty());
}

}  // namespace series_linear_system_test
