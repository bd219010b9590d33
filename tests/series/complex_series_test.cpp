#include "libration/series/complex_series.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace series_complex_series_test {

using namespace libration;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the square of the series of 1/(1 - ix) is that of its derivative over i", "[series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 1/(1 - ix) = sum i^n x^n, its square sum (n+1) i^n x^n: whole numbers, exact in every scalar.
    const complex_number<T> i{T(0), T(1)};
    complex_series<T> f({T(1), T(0)}, false);
    for (int n = 1; n <= 8; ++n) {
        f.push_back(f[n - 1] * i);
    }
    for (int n = 0; n <= 8; ++n) {
        const auto square = product_coefficient(f, f, n);
        CHECK(modulus_of(square - f[n] * T(n + 1)) == 0);
    }
    // At x = 1: 1 + i - 1 - i + ... to i^8 is 1.
    CHECK(modulus_of(evaluate(f, complex_number<T>{T(1), T(0)}) - complex_number<T>{T(1), T(0)}) == 0);
}

TEMPLATE_LIST_TEST_CASE("a series known to be real has the same products", "[series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    complex_series<T> real({T(2), T(0)}, true);
    complex_series<T> any({T(2), T(0)}, false);
    for (int n = 1; n <= 5; ++n) {
        real.push_back({T(n), T(0)});
        any.push_back({T(n), T(0)});
    }
    for (int n = 0; n <= 5; ++n) {
        CHECK(modulus_of(product_coefficient(real, real, n) - product_coefficient(any, any, n)) == 0);
    }
}

}  // namespace series_complex_series_test
