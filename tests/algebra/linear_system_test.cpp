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

}  // namespace series_linear_system_test
