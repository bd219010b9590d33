#include "libration/series/square_root.hpp"

#include <catch2/catch.hpp>

#include "libration/series/exponential.hpp"
#include "scalars.hpp"

namespace series_square_root_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

TEMPLATE_LIST_TEST_CASE("the square root of 1 + 4x has Catalan's numbers", "[series][square_root]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // sqrt(1+4x) = 1 + 2x - 2x^2 + 4x^3 - 10x^4 + 28x^5: integers, and from -1 the negative ones.
    const power_series<T> f(std::vector<T>{T(1), T(4), T(0), T(0), T(0), T(0)});
    const std::vector<int> expected{1, 2, -2, 4, -10, 28};
    for (const int sign : {1, -1}) {
        const auto root = square_root(f, T(sign));
        for (int n = 0; n <= 5; ++n) {
            CHECK(root[n] == expected[static_cast<std::size_t>(n)] * sign);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a square root is the power 1/2, and parity changes nothing", "[series][square_root]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 4 - x^2 - x^4/2 + x^6/8 and 12 zeros more
    auto f = power_series<T>::zero(18);
    f[0] = T(4);
    f[2] = T(-1);
    f[4] = T(-1) / 2;
    f[6] = T(1) / 8;
    const auto root = square_root(f, T(2));
    const auto even = square_root(f, T(2), parity::even);
    const auto power_half = power(f, T(T(1) / 2));
    for (int n = 0; n <= 18; ++n) {
        CHECK(root[n] == even[n]);
        CHECK_THAT(root[n], near(power_half[n], 100, T(1)));  // sums of 18 terms below 1
    }
}

}  // namespace series_square_root_test
