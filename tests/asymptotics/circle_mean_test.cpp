// The mean of |y| over a circle compared with elliptic integrals.
#include "libration/asymptotics/circle_mean.hpp"

#include <catch2/catch.hpp>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace asymptotics_circle_mean_test {

using namespace libration;
using namespace libration::ode;

// Of 1/|1 - t| over |t| = 2: (2/pi) K(1/2)/2 = 0.53662..; of 1 + 3t over |t| = 3 it is between 9 and 10.
TEST_CASE("an upper bound of the mean, and not far above it", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const explicit_system pole{parse("y' = y^2; y(0) = 1")};
    const chart_atlas atlas(pole, 1.6);
    const charted_covering covering(pole, atlas, {.rho = 2});
    const double mean = circle_mean(covering, 2, {}).above();
    CHECK(mean > 0.53661);
    CHECK(mean < 0.65);
    const explicit_system line{parse("y' = 3; y(0) = 1")};
    const chart_atlas plain(line, 1.6);
    const charted_covering around(line, plain, {.rho = 3});
    const double linear = circle_mean(around, 3, {}).above();
    CHECK(linear > 9);
    CHECK(linear < 11);
}

TEST_CASE("no mean on a circle through a pole", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const explicit_system pole{parse("y' = y^2; y(0) = 1")};
    const chart_atlas atlas(pole, 1.6);
    const charted_covering covering(pole, atlas, {.rho = 1});
    CHECK_THROWS_AS(circle_mean(covering, 1, {}), error);
}

}  // namespace asymptotics_circle_mean_test
