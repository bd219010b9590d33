#include "libration/convergence/strided_series.hpp"

#include <catch2/catch.hpp>

#include "libration/convergence/coefficient_ratios.hpp"
#include "scalars.hpp"

namespace convergence_strided_series_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEST_CASE("a class of indices is a series of its own", "[convergence][strided_series]") {
    const strided_series<double> c(power_series<double>({0, 1, 2, 3, 4, 5, 6, 7, 8}), 2, 3);
    CHECK(c.last() == 2);
    CHECK(c[0] == 2);
    CHECK(c[1] == 5);
    CHECK(c[2] == 8);
    CHECK(c.power(2) == 8);
    CHECK_THROWS_AS(strided_series<double>(power_series<double>({1, 2}), 2, 1), libration::error);
    CHECK_THROWS_AS(strided_series<double>(power_series<double>({1, 2}), 0, 0), libration::error);
    CHECK_THROWS_AS(strided_series<double>(power_series<double>({1, 2}), -1, 1), libration::error);
}

TEST_CASE("ratios leave out what would divide by 0", "[convergence][coefficient_ratios]") {
    const auto ratios = ratios_of(strided_series<double>(power_series<double>({1, 2, 0, 3, 6}), 0, 1));
    REQUIRE(ratios.size() == 3);
    CHECK(ratios[0].n == 1);
    CHECK(ratios[0].value == 2);
    CHECK(ratios[1].value == 0);
    CHECK(ratios[2].n == 4);
    CHECK(ratios[2].value == 2);
}

TEMPLATE_LIST_TEST_CASE("roots of the power are those of least argument", "[convergence][strided_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    // The cube of (1 + i sqrt 3) is -8; its square -2 + 2 i sqrt 3; exp and log cost a few roundings.
    const T root = sqrt(T(3));
    const auto cube = stride_root(complex_number<T>{T(-8), T(0)}, 3);
    CHECK_THAT(cube.re, near<T>(T(1), 8));
    CHECK_THAT(cube.im, near<T>(root, 8));
    const auto square = stride_root(complex_number<T>{T(-2), T(root * 2)}, 2);
    CHECK_THAT(square.re, near<T>(T(1), 8));
    CHECK_THAT(square.im, near<T>(root, 8));
    CHECK(stride_root(complex_number<T>{T(-2), T(1)}, 1).re == T(-2));
    CHECK(stride_root(complex_number<T>{T(16), T(0)}, 2).re == T(4));
}

TEMPLATE_LIST_TEST_CASE("an answer in the power is one in the variable", "[convergence][strided_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    radius_estimate<T> in_power;
    in_power.radius = T(4);
    in_power.uncertainty = T(1) / 100;
    in_power.position = complex_number<T>{T(-4), T(0)};
    in_power.count = 1;
    const auto answer = in_variable(in_power, 2);
    CHECK(*answer.radius == 2);
    CHECK_THAT(answer.uncertainty, near<T>(T(T(1) / 400), 4));  // d sqrt w = dw/(2 sqrt w)
    CHECK(answer.position->re == 0);
    CHECK(answer.position->im == 2);
    CHECK(answer.count == 2);
}

}  // namespace convergence_strided_series_test
