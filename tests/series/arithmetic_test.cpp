#include "libration/series/arithmetic.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"
#include "series/random_series.hpp"

namespace series_arithmetic_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

namespace {

template <class T>
void check_same(const power_series<T>& a, const power_series<T>& b) {
    CHECK(a.coefficients() == b.coefficients());
}

}  // namespace

// Integer coefficients of this size make every operation exact: the laws hold bit by bit.
TEMPLATE_LIST_TEST_CASE("series are a ring with units", "[series][arithmetic]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    for (int round = 0; round < 10; ++round) {
        const auto a = random.of_order<T>(12, 2);
        const auto b = random.of_order<T>(12, -1);
        const auto c = random.of_order<T>(12, 0);
        check_same<T>(a * b, b * a);
        check_same<T>((a * b) * c, a * (b * c));
        check_same<T>(a * (b + c), a * b + a * c);
        check_same<T>((a + b) - b, a);
        check_same<T>((a * b) / b, a);
        check_same<T>((a / b) * b, a);
    }
}

TEMPLATE_LIST_TEST_CASE("derivative and integral are inverse, and Leibniz is right", "[series][arithmetic]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const auto a = random.of_order<T>(12, 2);
    const auto b = random.of_order<T>(12, -1);
    check_same<T>(derivative(a * b), derivative(a) * b + a * derivative(b));
    check_same<T>(integral(derivative(a), a[0]), a);  // n a_n / n is exact
    // a_n/(n+1) is rounded once, times n+1 once more: half an epsilon each.
    const auto there_and_back = derivative(integral(a, T(7)));
    REQUIRE(there_and_back.order() == a.order());
    for (int n = 0; n <= a.order(); ++n) {
        CHECK_THAT(there_and_back[n], tests::near<T>(a[n], 1));
    }
    CHECK(integral(a, T(7))[0] == 7);
    check_same<T>(derivative(power_series<T>(std::vector<T>{T(5)})), power_series<T>());
}

TEMPLATE_LIST_TEST_CASE("a result knows no more than its operands, and its prefix does not depend on the order",
                        "[series][arithmetic]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    // Thirds: sums and products are rounded, and must be rounded alike.
    const auto thirds = [&](int constant) {
        auto series = random.of_order<T>(20, constant);
        for (int n = 0; n <= 20; ++n) {
            series[n] /= 3;
        }
        return series;
    };
    const auto a = thirds(2);
    const auto b = thirds(1);
    const auto short_b = b.truncated(7);
    check_same<T>(a + short_b, (a + b).truncated(7));
    check_same<T>(a - short_b, (a - b).truncated(7));
    check_same<T>(a * short_b, (a * b).truncated(7));
    check_same<T>(a / short_b, (a / b).truncated(7));
    check_same<T>(short_b / a, (b / a).truncated(7));
}

TEMPLATE_LIST_TEST_CASE("the geometric series and its square are known", "[series][arithmetic]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto one = power_series<T>::zero(10);
    one[0] = T(1);
    auto one_minus_x = one;
    one_minus_x[1] = T(-1);
    const auto geometric = one / one_minus_x;
    const auto squared = geometric * geometric;
    for (int n = 0; n <= 10; ++n) {
        CHECK(geometric[n] == 1);
        CHECK(squared[n] == n + 1);
    }
}

TEMPLATE_LIST_TEST_CASE("evaluation gives value and derivative of the polynomial", "[series][arithmetic]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    for (const int numerator : {0, 3, -5, 8, 12}) {
        const auto a = random.of_order<T>(8, -2);
        // The same sums as fractions: x is in quarters, so nothing is rounded in any scalar (2 + 8 * 4 bits).
        const rational x = rational(numerator) / 4;
        rational value = 0;
        rational slope = 0;
        rational power = 1;
        for (int n = 0; n <= 8; ++n) {
            const auto coefficient = static_cast<int>(a[n]);
            value += coefficient * power;
            slope += n < 8 ? rational((n + 1) * static_cast<int>(a[n + 1]) * power) : rational(0);
            power *= x;
        }
        const jet<T> at = evaluate(a, T(T(numerator) / 4));
        CHECK(at.value == from_rational<T>(value));
        CHECK(at.slope == from_rational<T>(slope));
        CHECK(at.slope == evaluate(derivative(a), T(T(numerator) / 4)).value);
    }
    CHECK(evaluate(power_series<T>(std::vector<T>{T(5)}), T(3)).value == 5);
    CHECK(evaluate(power_series<T>(std::vector<T>{T(5)}), T(3)).slope == 0);
}

}  // namespace series_arithmetic_test
