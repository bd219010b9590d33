#include "libration/approximant/truncated_series.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_truncated_series_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

TEMPLATE_LIST_TEST_CASE("a truncated series is its polynomial in the scaled time", "[approximant][truncated_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 3 - 2 x + 5 x^3 with x = t/4 at t = 2 and t = -6: exact in every scalar.
    const truncated_series<T> sigma(power_series<T>(std::vector<T>{T(3), T(-2), T(0), T(5)}), T(4));
    CHECK(sigma.order() == 3);
    CHECK(sigma.scale() == 4);
    CHECK(sigma.scaled()[3] == 5);
    const jet<T> inside = sigma(T(2));
    CHECK(inside.value == T(21) / 8);  // 3 - 1 + 5/8
    CHECK(inside.slope == T(7) / 16);  // (-2 + 15/4) / 4
    const jet<T> beyond = sigma(T(-6));
    CHECK(beyond.value == T(-87) / 8);   // 3 + 3 - 135/8
    CHECK(beyond.slope == T(127) / 16);  // (-2 + 135/4) / 4
}

TEMPLATE_LIST_TEST_CASE("the scale of a truncated series is a matter of notation", "[approximant][truncated_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const power_series<T> unscaled(std::vector<T>{T(1), T(-7), T(2), T(3), T(-1)});
    const truncated_series<T> plain(unscaled, T(1));
    const truncated_series<T> scaled(rescale(unscaled, T(8)), T(8));
    for (const int quarters : {0, 1, 5, -3}) {
        const T t = T(quarters) / 4;
        CHECK(scaled(t).value == plain(t).value);
        CHECK(scaled(t).slope == plain(t).slope);
    }
}

TEMPLATE_LIST_TEST_CASE("a scale keeps coefficients that would leave the range of double",
                        "[approximant][truncated_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 1/(1 - t/1024) to order 400: a_400 = 2^-4000.
    const truncated_series<T> sigma(power_series<T>(std::vector<T>(401, T(1))), T(1024));
    CHECK(sigma(T(1024)).value == 401);
    CHECK(sigma(T(512)).value + ldexp(T(1), -400) == 2);
}

TEST_CASE("the value alone of a partial sum has the bits of the jet's", "[approximant]") {
    const truncated_series<double> sum(power_series<double>(std::vector<double>{1, -0.3, 0.7, 0.01, -0.2}), 1.7);
    for (const double t : {0.0, 0.3, 1.7, 4.0}) {
        CHECK(sum.value(t) == sum(t).value);
    }
}

}  // namespace approximant_truncated_series_test
