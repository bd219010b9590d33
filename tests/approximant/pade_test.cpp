#include "libration/approximant/pade.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_pade_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

namespace {

template <class T>
power_series<T> exponential_series(int order) {
    auto f = power_series<T>::zero(order);
    f[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        f[n] = f[n - 1] / n;
    }
    return f;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a rational function is recovered from its series", "[approximant][pade]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // (2 - 3x + x^2) / (1 + x/2 - x^2/4 + x^3/8)
    const power_series<T> p(std::vector<T>{T(2), T(-3), T(1), T(0), T(0), T(0)});
    const power_series<T> q(std::vector<T>{T(1), T(1) / 2, T(-1) / 4, T(1) / 8, T(0), T(0)});
    const auto found = *pade(p / q, 2, 3);
    for (int n = 0; n <= 2; ++n) {
        CHECK_THAT(found.numerator[n], near(p[n], 200, T(3)));  // a system of condition 1e1 with three eliminations
    }
    for (int n = 0; n <= 3; ++n) {
        CHECK_THAT(found.denominator[n], near(q[n], 200, T(1)));
    }
    const jet<T> at = found(T(1));  // 0 with the slope (-3 + 2)/(1 + 1/2 - 1/4 + 1/8)
    CHECK_THAT(at.value, near(T(0), 400, T(1)));
    CHECK_THAT(at.slope, near(T(T(-8) / 11), 400));
}

TEMPLATE_LIST_TEST_CASE("the approximants of exp are those of Pade", "[approximant][pade]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // [L/M]: p_j = C(L, j) (L+M-j)!/(L+M)!, q_j = (-1)^j the same with M [DLMF 3.11(iv)].
    for (const auto& [l, m] : {std::pair{0, 1}, std::pair{1, 1}, std::pair{3, 2}, std::pair{3, 3}, std::pair{4, 0}}) {
        const auto found = *pade(exponential_series<T>(l + m), l, m);
        const auto closed = [&, sum = l + m](int degree, int j) {
            T value(1);
            for (int i = 0; i < j; ++i) {
                value = value * (degree - i) / ((i + 1) * (sum - i));
            }
            return value;
        };
        INFO("[" << l << "/" << m << "]");
        REQUIRE(found.numerator.order() == l);
        REQUIRE(found.denominator.order() == m);
        for (int j = 0; j <= l; ++j) {
            // The system of [3/3] has the condition 1.6e4; 20 operations on each entry.
            CHECK_THAT(found.numerator[j], near(closed(l, j), 10'000, T(1)));
        }
        for (int j = 0; j <= m; ++j) {
            CHECK_THAT(found.denominator[j], near(T(closed(m, j) * (j % 2 == 0 ? 1 : -1)), 10'000, T(1)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the approximants 1/1 and 2/2 of log(1+x)/x are the continued fraction", "[approximant][pade]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto f = power_series<T>::zero(4);
    for (int n = 0; n <= 4; ++n) {
        f[n] = T(n % 2 == 0 ? 1 : -1) / (n + 1);
    }
    const auto one = *pade(f, 1, 1);  // (6 + x)/(6 + 4x)
    CHECK_THAT(one.numerator[1], near(T(T(1) / 6), 20));
    CHECK_THAT(one.denominator[1], near(T(T(2) / 3), 20));
    const auto two = *pade(f, 2, 2);                         // (30 + 21x + x^2)/(30 + 36x + 9x^2)
    CHECK_THAT(two.numerator[1], near(T(T(7) / 10), 2000));  // the condition is 500
    CHECK_THAT(two.numerator[2], near(T(T(1) / 30), 2000, T(1)));
    CHECK_THAT(two.denominator[1], near(T(T(6) / 5), 2000));
    CHECK_THAT(two.denominator[2], near(T(T(3) / 10), 2000));
}

TEST_CASE("Pade approximants of log(1+x)/x converge where the series diverges", "[approximant][pade]") {
    const precision_scope scope(80);
    auto f = power_series<mpfr>::zero(40);
    for (int n = 0; n <= 40; ++n) {
        f[n] = mpfr(n % 2 == 0 ? 1 : -1) / (n + 1);
    }
    // Error of [n/n] at x: about 2 pi |(1 - sqrt(1+x))/(1 + sqrt(1+x))|^(2n+1) = 2 pi (1/3)^(4n+2) at x = 3 with
    // sqrt(1+x) = 2 taken twice (square of the map for Stieltjes functions): 3^-41 at n = 20 leaves 1e-19.
    const mpfr error = abs((*pade(f, 20, 20))(mpfr(3)).value - log(mpfr(4)) / 3);
    CHECK(error < mpfr("1e-18"));
    CHECK(error > 0);
}

TEST_CASE("what has no approximant is refused", "[approximant][pade]") {
    // 1 + x^2: [1/1] would need q_1 with 0 q_1 = -1.
    const power_series<double> f({1, 0, 1, 0, 1});
    CHECK_FALSE(pade(f, 1, 1));
    CHECK(pade(f, 2, 2));  // 1/(1 - x^2), whose Q has the degree 2
    // exp has every approximant, and a series that is rational already has none of higher degrees.
    const power_series<double> geometric({1, 1, 1, 1, 1});
    CHECK_FALSE(pade(geometric, 2, 2));
    CHECK_THROWS_AS(pade(geometric, 3, 2), libration::error);
    CHECK_THROWS_AS(pade(geometric, -1, 2), libration::error);
}

}  // namespace approximant_pade_test
