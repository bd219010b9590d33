#include "libration/convergence/test/pole_pair.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_pole_pair_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("four coefficients give the radius of a pair of logarithms", "[convergence]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto a = logarithms_of_a_pair<T>(40);
    // The recurrences of cosine and power lose a unit a step, and the stride divides them by 2 or 4.
    CHECK_THAT(pole_pair_radius(a, 20, 1), near<T>(T(5) / 4, 200));
    CHECK_THAT(pole_pair_radius(a, 20, 2), near<T>(T(5) / 4, 200));
    CHECK_THROWS_AS(pole_pair_radius(a, 38, 1), libration::error);
    CHECK_THROWS_AS(pole_pair_radius(a, 0, 1), libration::error);
}

TEMPLATE_LIST_TEST_CASE("two coefficients give the radius of a single logarithm", "[convergence]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto a = power_series<T>::zero(20);
    for (int n = 2; n <= 20; n += 2) {
        a[n] = (n % 4 == 0 ? T(1) : T(-1)) / n / (T(1 << (n / 2)));  // singular at +-i sqrt 2
    }
    using std::sqrt;
    CHECK_THAT(single_pole_radius(a, 10, 2), near<T>(T(sqrt(T(2))), 10));
    CHECK_THROWS_AS(single_pole_radius(a, 19, 2), libration::error);
}

}  // namespace convergence_pole_pair_test
