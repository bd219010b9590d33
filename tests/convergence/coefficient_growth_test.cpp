#include "libration/convergence/coefficient_growth.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace convergence_coefficient_growth_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

// a_n = a_{n-1} factor(n), a_0 = 1, scaled so that neither end leaves the range of double.
template <class T, class Factor>
strided_series<T> product(int order, const Factor& factor) {
    auto a = power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        a[n] = a[n - 1] * factor(T(n));
    }
    return strided_series<T>(a, 0, 1);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("entire, geometric and divergent coefficients are told apart",
                        "[convergence][coefficient_growth]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const int order : {16, 30, 60, 120}) {
        INFO(order);
        const T unit(order);
        CHECK(growth_of(product<T>(order, [&](const T& n) { return T(unit / n); })).kind == growth::entire);
        // 16 coefficients are too few for a radius of 0.
        const growth factorial = growth_of(product<T>(order, [&](const T& n) { return T(n / unit); })).kind;
        CHECK(factorial == (order < 30 ? growth::geometric : growth::divergent));
        // (1-x)^nu: powers n^(-nu-1), with 16 coefficients from about n^-2 to n, else from n^-4 to n^2.
        const int steepest = order < 30 ? 1 : 3;
        for (int nu = -steepest; nu <= steepest; ++nu) {
            const auto power = product<T>(order, [&](const T& n) { return T((n - nu - T(7) / 10) / n); });
            CHECK(growth_of(power).kind == growth::geometric);
        }
    }
}

TEST_CASE("gamma is minus one over the order of an entire function", "[convergence][coefficient_growth]") {
    // 1/n!^(1/rho) for rho = 1, 1/2, 2: log a_n = -(1/rho)(n log n - n) to O(log n).
    const precision_scope scope(40);
    for (const auto& [twice, expected] : {std::pair{2, 1.0}, {4, 2.0}, {1, 0.5}}) {
        const auto c = product<mpfr>(
            200, [twice = twice](const mpfr& n) { return mpfr(pow(mpfr(200 / n), mpfr(mpfr(twice) / 2))); });
        // The term (1/2) log n of Stirling's formula leaves 2/K.
        CHECK(abs(growth_of(c).gamma + expected) < 2.0 * expected / 200 * 2);
    }
}

TEST_CASE("coefficients that swing and vanish do not disturb the growth", "[convergence][coefficient_growth]") {
    // cos(n phi)/n for a pair; 1, -1, 0 of 1/(1 + x + x^2).
    const precision_scope scope(30);
    auto pair = power_series<mpfr>::zero(100);
    auto zeros = power_series<mpfr>::zero(100);
    for (int n = 1; n <= 100; ++n) {
        pair[n] = cos(mpfr(n)) / n;
        zeros[n] = n % 3 == 2 ? 0 : n % 3 == 0 ? 1 : -1;
    }
    CHECK(growth_of(strided_series<mpfr>(pair, 0, 1)).kind == growth::geometric);
    CHECK(growth_of(strided_series<mpfr>(zeros, 0, 1)).kind == growth::geometric);
}

TEST_CASE("too few coefficients tell no growth", "[convergence][coefficient_growth]") {
    CHECK(growth_of(strided_series<double>(power_series<double>({1, 2, 3, 4, 5, 6}), 0, 1)).kind == growth::unknown);
    CHECK(growth_of(strided_series<double>(power_series<double>::zero(80), 0, 1)).kind == growth::unknown);
}

}  // namespace convergence_coefficient_growth_test
