#include "libration/convergence/test/ratio_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_ratio_test_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the ratio test reads a geometric series and covers its own error on a logarithm",
                        "[convergence][ratio_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto geometric = ratio_test(every_coefficient(binomial_series(T(-3), T(-1), 40)));
    REQUIRE(geometric.radius);
    // One division, after one in the series.
    CHECK_THAT(*geometric.radius, near(T(3), 4));
    CHECK(geometric.position->re < 0);
    // (1 - x)^(1/3): the error is (4/3)/N.
    const auto root = ratio_test(every_coefficient(binomial_series(T(1), T(T(1) / 3), 60)));
    CHECK(covers(root, T(1)));
    CHECK(root.uncertainty * 10 < 1);
}

TEMPLATE_LIST_TEST_CASE("the ratio test refuses zeros and scattering ratios with the reason",
                        "[convergence][ratio_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto even = power_series<T>::zero(40);
    for (int n = 0; n <= 40; n += 2) {
        even[n] = T(n % 4 == 0 ? 16 : -16);
    }
    CHECK(ratio_test(every_coefficient(even)).note.find("divides by 0") == 0);
    // 1/(1 + x^2): in x^2 a single pole at -1, in x the pair +-i.
    const auto in_power = ratio_test_in_power(strided_series<T>(even, 0, 2));
    REQUIRE(in_power.radius);
    CHECK_THAT(*in_power.radius, near(T(1), 2));
    CHECK_THAT(in_power.position->im, near(T(1), 2));
    CHECK(in_power.count == 2);
    const auto pair = ratio_test(every_coefficient(gegenbauer_series(T(T(3) / 10), T(-1), 60)));
    CHECK(pair.note.find("the ratios scatter between") == 0);
    CHECK(ratio_test(every_coefficient(power_series<T>::zero(4))).note.find("needs 8") == 0);
}

TEMPLATE_LIST_TEST_CASE("the ratio test gives a finite answer or a reason on any list", "[convergence][ratio_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(ratio_test(every_coefficient(a))));
    }
}

TEMPLATE_LIST_TEST_CASE("the ratio test in a power gives a finite answer or a reason on any list",
                        "[convergence][ratio_test_in_power]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(ratio_test_in_power(every_coefficient(a))));
    }
}

}  // namespace convergence_ratio_test_test
