#include "libration/series/power_series.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace series_power_series_test {

using namespace libration;
using namespace libration::series;
using Catch::Contains;
using libration::tests::all_scalars;

TEMPLATE_LIST_TEST_CASE("a series of order N holds the degrees 0 to N", "[series][power_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    power_series<T> series(std::vector<T>{T(3), T(1), T(4)});
    CHECK(series.order() == 2);
    CHECK(series[0] == 3);
    CHECK(series[2] == 4);
    series.push_back(T(1));
    CHECK(series.order() == 3);
    CHECK(series.truncated(1).coefficients() == std::vector<T>{T(3), T(1)});
    CHECK(series.truncated(3).coefficients() == series.coefficients());
    CHECK(power_series<T>().coefficients() == std::vector<T>{T(0)});
    CHECK(power_series<T>::zero(2).coefficients() == std::vector<T>(3, T(0)));
}

TEMPLATE_LIST_TEST_CASE("a series in another unit has the same values", "[series][power_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const power_series<T> series(std::vector<T>{T(5), T(-3), T(2), T(7)});
    // 5 - 3 x + 2 x^2 + 7 x^3 at x = 3 y.
    CHECK(rescale(series, T(3)).coefficients() == std::vector<T>{T(5), T(-9), T(18), T(189)});
    CHECK(rescale(rescale(series, T(4)), T(T(1) / 4)).coefficients() == series.coefficients());
    CHECK(rescale(series, T(0)).coefficients() == std::vector<T>{T(5), T(0), T(0), T(0)});
}

TEST_CASE("an order that no series has is refused with its value", "[series][power_series]") {
    using series = power_series<double>;
    CHECK_THROWS_AS(series::zero(-1), libration::error);
    CHECK_THROWS_WITH(series::zero(-3), Contains("-3"));
    CHECK_THROWS_AS(series(std::vector<double>()), libration::error);
    CHECK_THROWS_WITH(series::zero(4).truncated(5), Contains("5") && Contains("4"));
    CHECK_THROWS_WITH(series::zero(4).truncated(-1), Contains("-1"));
}

}  // namespace series_power_series_test
