#include "libration/convergence/root_test.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

using namespace libration;
using namespace libration::tests;

TEST_CASE("the root test is right about a geometric series and refuses too short ones", "[convergence][root_test]") {
    // a_n = 2^-n has the radius 2 exactly, whatever n.
    auto geometric = power_series<mpfr>::zero(20);
    const precision_scope scope(40);
    for (int n = 0; n <= 20; ++n) {
        geometric[n] = ldexp(mpfr(1), -n);
    }
    CHECK_THAT(radius_by_root_test(geometric), near(mpfr(2), 4));
    CHECK_THROWS_AS(radius_by_root_test(power_series<double>({1, 2, 3, 4})), std::domain_error);
    CHECK_THROWS_AS(radius_by_root_test(power_series<double>::zero(8)), std::domain_error);
}
