#include "libration/approximant/branch_approximant.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_branch_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

TEST_CASE("a branch point is taken off a series over fractions", "[approximant][asymptotic]") {
    // (1 - t^2/4)^3 (1 + t) is a polynomial.
    auto factor = power_series<rational>(std::vector<rational>{1, 0, rational(-1, 4), 0, 0, 0, 0, 0, 0});
    auto line = power_series<rational>(std::vector<rational>{1, 1, 0, 0, 0, 0, 0, 0, 0});
    const auto left = without_branch_point(factor * factor * factor * line, rational(2), rational(3), 2);
    for (int n = 0; n <= 8; ++n) {
        CHECK(left[n] == line[n]);
    }
    CHECK_THROWS_WITH(without_branch_point(line, rational(1), rational(1), 0), Catch::Contains("is less than 1"));
}

TEMPLATE_LIST_TEST_CASE("the branch approximant of its own form is exact to its end", "[approximant][asymptotic]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    // sqrt(1 - t/3) (2 + t): binomial series with C(1/2, n) (-1/3)^n.
    auto root = power_series<T>::zero(10);
    root[0] = T(1);
    for (int n = 1; n <= 10; ++n) {
        root[n] = root[n - 1] * (2 * n - 3) / (6 * n);
    }
    auto line = power_series<T>::zero(10);
    line[0] = T(2);
    line[1] = T(1);
    const branch_approximant<T> of(root * line, T(3), T(1) / 2, 1);
    for (const int eighths : {0, 5, 12, 20, 23}) {
        const T t = T(eighths) / 8;
        // Rounding in ten A_n, some 10 eps each, raised by 3^n at the end of the interval against 3^-n of the A_n.
        CHECK_THAT(of.value(t), near(T(sqrt(T(1 - t / 3)) * (2 + t)), 200, T(2)));
    }
    CHECK(of.value(T(3)) == 0);
}

}  // namespace approximant_branch_test
