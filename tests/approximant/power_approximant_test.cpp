#include "libration/approximant/power_approximant.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_power_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

namespace {

// a/(n + 1) with signs that follow no rule.
template <class R>
power_series<R> some_series(int order) {
    auto f = power_series<R>::zero(order);
    for (int n = 0; n <= order; ++n) {
        f[n] = R(R(n % 3 == 1 ? -2 : 5) / (n + 1));
    }
    return f;
}

}  // namespace

TEST_CASE("the bracket of a power undoes the power over fractions", "[approximant][asymptotic]") {
    const auto f = some_series<rational>(12);
    const power_series<rational> far(std::vector<rational>{rational(-3, 2), 1});
    const auto distance = distance_from_far(f, far);
    const auto reciprocal = bracket_of_power(f, far, rational(-1));
    const auto cube = bracket_of_power(f, far, rational(3));
    for (int n = 0; n <= 12; ++n) {
        CHECK((reciprocal * distance)[n] == (n == 0 ? distance[0] : rational(0)));
        CHECK((distance * distance * distance)[n] == cube[n] * distance[0] * distance[0] * distance[0]);
    }
    const auto root = bracket_of_power(f, far, rational(1, 2));
    for (int n = 0; n <= 12; ++n) {
        CHECK((root * root)[n] * distance[0] == distance[n]);
    }
    CHECK_THROWS_WITH(distance_from_far(f, f), Catch::Contains("has the same value at 0 as the function"));
}

TEMPLATE_LIST_TEST_CASE("an approximant of its own form is exact", "[approximant][asymptotic]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // t - 1 + 2/(1 + t + t^2/2): the geometric series of the bracket, here by division.
    const power_series<T> bracket(std::vector<T>{T(1), T(1), T(1) / 2, T(0), T(0), T(0)});
    auto two = power_series<T>::zero(5);
    two[0] = T(2);
    auto f = two / bracket;
    f[0] -= 1;
    f[1] += 1;
    const power_approximant<T> of(f, power_series<T>(std::vector<T>{T(-1), T(1)}), T(-1));
    REQUIRE(of.order() == 5);
    // At t = 2 the bracket is 5, its slope 3; rounding in the A_n beyond 2, some 20 eps, is raised by 2^5.
    const jet<T> at = of(T(2));
    CHECK_THAT(at.value, near(T(T(7) / 5), 1000));
    CHECK_THAT(at.slope, near(T(T(19) / 25), 2000));
    CHECK_THAT(of.value(T(0)), near(T(1), 2));
}

TEMPLATE_LIST_TEST_CASE("a power that is no whole number decays as it should", "[approximant][asymptotic]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    // (1 + t)^(-1/2) = ((1 + t)^2)^(-1/4): a bracket of degree 2.
    auto f = power_series<T>::zero(2);
    f[0] = T(1);
    f[1] = T(-1) / 2;
    f[2] = T(3) / 8;
    const power_approximant<T> of(f, power_series<T>::zero(0), T(-1) / 4);
    CHECK_THAT(of.bracket()[1], near(T(2), 8));
    CHECK_THAT(of.bracket()[2], near(T(1), 16));
    CHECK_THAT(of.value(T(99)), near(T(T(1) / 10), 40));  // the logarithm of 10^4, 9, is rounded once
    CHECK_THAT(of(T(99)).slope, near(T(T(-1) / 2000), 80));
}

}  // namespace approximant_power_test
