#include "libration/scalar/enclose.hpp"

#include <catch2/catch.hpp>

#include "scalar/random_value.hpp"
#include "scalars.hpp"

namespace scalar_enclose_test {

using namespace libration;
using libration::tests::all_scalars;

TEMPLATE_LIST_TEST_CASE("a rounding scalar is not moved by what was left out", "[scalar][enclose]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T value = T(1) / 3;
    CHECK(enclose(value, T(100)) == value);
}

TEMPLATE_LIST_TEST_CASE("the binary exponent brackets the value", "[scalar][enclose]", all_scalars) {
    using T = typename TestType::type;
    using std::abs, std::ldexp;
    const typename TestType::precision precision;
    CHECK(binary_exponent(T(1)) == 1);
    CHECK(binary_exponent(T(-8)) == 4);
    CHECK(binary_exponent(T(1) / 3) == -1);
    CHECK(binary_exponent(T(0)) == exponent_of_zero);
    tests::random_value<T> random;
    for (int i = 0; i < 200; ++i) {
        const T x = random();
        const auto exponent = static_cast<int>(binary_exponent(x));
        // Scaled into [1/2, 1) in two steps: 2^-exponent itself may be out of range.
        const T scaled = ldexp(ldexp(T(abs(x)), -exponent / 2), -exponent + exponent / 2);
        REQUIRE(scaled * 2 >= 1);
        REQUIRE(scaled < 1);
        REQUIRE(exponent > exponent_of_zero);
    }
}

TEST_CASE("doublings reach their number and no earlier count does", "[scalar][enclose]") {
    STATIC_REQUIRE(doublings(1) == 0);
    STATIC_REQUIRE(doublings(0) == 0);
    STATIC_REQUIRE(doublings(-7) == 0);
    STATIC_REQUIRE(doublings(2) == 1);
    for (long n = 2; n < 5000; ++n) {
        const int steps = doublings(n);
        REQUIRE((1L << steps) >= n);
        REQUIRE((1L << (steps - 1)) < n);
    }
}

}  // namespace scalar_enclose_test
