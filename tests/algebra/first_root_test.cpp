#include "libration/algebra/first_root.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "scalars.hpp"

namespace algebra_first_root_test {

using namespace libration;
using namespace libration::series;
using namespace libration::tests;

namespace {

// The product of polynomials given by their coefficients.
template <class T>
power_series<T> product_of(const std::vector<std::vector<T>>& factors) {
    std::vector<T> all{T(1)};
    for (const auto& factor : factors) {
        std::vector<T> next(all.size() + factor.size() - 1, T(0));
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = 0; j < factor.size(); ++j) {
                next[i + j] += all[i] * factor[j];
            }
        }
        all = std::move(next);
    }
    return power_series<T>(std::move(all));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the least root of the unit interval is found by signs", "[algebra][first_root]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto x = [](int numerator, int denominator) { return T(numerator) / denominator; };
    // Roots 3/8, 3/4 and -1/2, 5/4, +- i beside them; values of size 1 with a slope above 1/4.
    const auto p =
        product_of<T>({{x(-3, 8), T(1)}, {x(-3, 4), T(1)}, {x(1, 2), T(1)}, {x(-5, 4), T(1)}, {T(1), T(0), T(1)}});
    REQUIRE(first_root(p));
    CHECK_THAT(*first_root(p), near(x(3, 8), 100, T(1)));
    // Ends belong to it.
    CHECK(*first_root(power_series<T>({T(0), T(1), T(3)})) == 0);
    CHECK(*first_root(power_series<T>({T(-1), T(1)})) == 1);
    CHECK(*first_root(power_series<T>({T(1), T(-2)})) == x(1, 2));
    // No root: beyond 1, below 0, a constant, and a pair 2^-8 beside 1/2.
    CHECK_FALSE(first_root(power_series<T>({T(-9), T(8)})));
    CHECK_FALSE(first_root(power_series<T>({T(1), T(8)})));
    CHECK_FALSE(first_root(power_series<T>({T(-3)})));
    CHECK_FALSE(first_root(power_series<T>({x(1, 4) + x(1, 65536), T(-1), T(1)})));
    // Two roots 2^-7 apart between others' signs.
    const auto close = first_root(power_series<T>({x(1, 4) - x(1, 65536), T(-1), T(1)}));
    REQUIRE(close);
    CHECK_THAT(*close, near(T(x(1, 2) - x(1, 256)), 1000, T(1)));
}

TEST_CASE("the least root of Chebyshev's polynomials is the cosine that it should be", "[algebra][first_root]") {
    const precision_scope scope(60);
    // T_n(2x - 1) from T_{n+1} = 2 (2x - 1) T_n - T_{n-1}: roots (1 - cos((2k - 1) pi/(2n)))/2, all of them in [0, 1].
    std::vector<mpfr> before{mpfr(1)};
    std::vector<mpfr> now{mpfr(-1), mpfr(2)};
    for (int n = 1; n <= 12; ++n) {
        const auto found = first_root(power_series<mpfr>(now));
        REQUIRE(found);
        INFO("n = " << n);
        // Coefficients of T_12 reach 10^8, and the slope at the first root is above 1.
        CHECK_THAT(*found, near(mpfr((1 - cos(mpfr(pi<mpfr>() / (2 * n)))) / 2), 10'000'000'000, mpfr(1)));
        std::vector<mpfr> next(now.size() + 1, mpfr(0));
        for (std::size_t i = 0; i < now.size(); ++i) {
            next[i + 1] += now[i] * 4;
            next[i] -= now[i] * 2;
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            next[i] -= before[i];
        }
        before = std::move(now);
        now = std::move(next);
    }
}

}  // namespace algebra_first_root_test
