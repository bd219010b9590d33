#include "libration/series/convolution.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/scalar/complex_number.hpp"
#include "proved.hpp"
#include "scalars.hpp"
#include "series/random_series.hpp"

namespace series_convolution_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

TEMPLATE_LIST_TEST_CASE("a convolution is the double sum over index pairs", "[series][convolution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const auto a = random.of_order<T>(9, 2);
    const auto b = random.of_order<T>(9, -1);
    for (int n = 0; n <= 9; ++n) {
        T whole(0);
        T inner(0);
        for (int i = 0; i <= 9; ++i) {
            for (int j = 0; j <= 9; ++j) {
                whole += i + j == n ? T(a[i] * b[j]) : T(0);
                inner += i + j == n && 2 <= i && i <= 7 ? T(a[i] * b[j]) : T(0);
            }
        }
        CHECK(product_coefficient(a, b, n) == whole);
        CHECK(convolution(a, b, n, 2, std::min(n, 7)) == inner);
    }
    CHECK(convolution(a, b, 5, 4, 3) == 0);
}

TEMPLATE_LIST_TEST_CASE("an inner product has every term, whatever their number and the steps", "[series][convolution]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    constexpr int most = 21;
    std::vector<T> x;
    std::vector<T> y;
    for (int i = 0; i <= 2 * most; ++i) {
        x.push_back(T(i + 1));
        y.push_back(T(i * i - 50));
    }
    for (int count = 0; count <= most; ++count) {
        for (const int x_step : {1, 2}) {
            for (const int y_step : {1, -1, 2, -2}) {
                INFO(count << " terms, steps " << x_step << " and " << y_step);
                const int from = y_step < 0 ? 2 * most : 0;
                int whole = 0;
                for (int i = 0; i < count; ++i) {
                    const int at = from + i * y_step;
                    whole += (i * x_step + 1) * (at * at - 50);
                }
                CHECK(inner_product(x.data(), x_step, &y[static_cast<std::size_t>(from)], y_step, count) == whole);
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the coefficient of a square is that of a product", "[series][convolution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const auto p = GENERATE(parity::any, parity::even, parity::odd);
    const auto a = random.of_order<T>(13, p == parity::odd ? 0 : 3, p);
    for (int n = 0; n <= 13; ++n) {
        INFO(n);
        CHECK(square_coefficient(a, n) == product_coefficient(a, a, n));
        CHECK(square_coefficient(a, n, p) == product_coefficient(a, a, n));
    }
}

TEMPLATE_LIST_TEST_CASE("a known parity saves products and changes nothing", "[series][convolution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const auto b = random.of_order<T>(12, 1);
    const auto p = GENERATE(parity::even, parity::odd);
    const auto a = random.of_order<T>(12, p == parity::odd ? 0 : 3, p);
    for (int n = 0; n <= 12; ++n) {
        CHECK(product_coefficient(a, b, n, p) == product_coefficient(a, b, n));
        for (int first = 0; first <= n; ++first) {
            CHECK(convolution(a, b, n, first, n, p) == convolution(a, b, n, first, n));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("parity counts terms and does not look at values", "[series][convolution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const power_series<T> ones(std::vector<T>(8, T(1)));
    CHECK(product_coefficient(ones, ones, 7) == 8);
    CHECK(product_coefficient(ones, ones, 7, parity::even) == 4);
    CHECK(product_coefficient(ones, ones, 6, parity::even) == 4);
    CHECK(product_coefficient(ones, ones, 6, parity::odd) == 3);
    CHECK(square_coefficient(ones, 6, parity::odd) == 3);
}

TEST_CASE("on balls whole products and quotients are those of their coefficients", "[series][convolution][ball]") {
    const precision_scope scope(40);
    tests::random_series random;
    for (const int order : {0, 3, 150}) {
        const auto a = random.of_order<ball>(order, 2);
        const auto b = random.of_order<ball>(order + 5, 1);
        const auto c = product(a, b);
        const auto back = quotient(c, b);
        REQUIRE(c.order() == order);
        for (int n = 0; n <= order; ++n) {
            INFO(n << " of " << order);
            CHECK(contains(c[n], product_coefficient(a, b, n)));
            CHECK(contains(back[n], a[n]));  // integers, exact
        }
    }
}

TEST_CASE("mpfr adds a product with one rounding", "[series][convolution]") {
    const precision_scope scope(40);
    // (1 + e)(1 - e) - 1 = -e^2, lost when the product is rounded before the sum.
    const mpfr e = epsilon<mpfr>();
    mpfr sum(-1);
    add_product(sum, mpfr(1 + e), mpfr(1 - e));
    CHECK(sum == -e * e);
}

TEMPLATE_LIST_TEST_CASE("an inner product of complex numbers is four of their parts", "[series][convolution]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    constexpr int most = 13;
    std::vector<complex_number<T>> x;
    std::vector<complex_number<T>> y;
    for (int i = 0; i <= 2 * most; ++i) {
        x.emplace_back(T(i + 1), T(3 - i * i));
        y.emplace_back(T(i * i - 50), T(2 * i));
    }
    for (int count = 1; count <= most; ++count) {
        for (const int x_step : {1, 2}) {
            for (const int y_step : {1, -1, 2, -2}) {
                INFO(count << " terms, steps " << x_step << " and " << y_step);
                const int from = y_step < 0 ? 2 * most : 0;
                complex_number<T> whole(0);
                for (int i = 0; i < count; ++i) {
                    whole += x[static_cast<std::size_t>(i * x_step)] * y[static_cast<std::size_t>(from + i * y_step)];
                }
                const auto sum = inner_product(x.data(), x_step, &y[static_cast<std::size_t>(from)], y_step, count);
                CHECK(sum == whole);  // whole numbers, exact in every scalar
            }
        }
    }
}

TEST_CASE("products and quotients run over fractions exactly", "[series][convolution]") {
    tests::random_series random;
    const auto a = random.of_order<rational>(20, 2);
    const auto b = random.of_order<rational>(20, 3);
    CHECK(quotient(product(a, b), b).coefficients() == a.coefficients());
    CHECK(product(quotient(a, b), b).coefficients() == a.coefficients());
    // 3/(3 - x) = sum (x/3)^n
    const power_series<rational> three(std::vector<rational>{3, 0, 0, 0});
    const power_series<rational> pole(std::vector<rational>{3, -1, 0, 0});
    CHECK(quotient(three, pole)[3] == rational(1) / 27);
}

}  // namespace series_convolution_test
