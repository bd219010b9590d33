#include "libration/convergence/extrapolation.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_extrapolation_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("Neville's table is exact for a polynomial in the reciprocal index",
                        "[convergence][extrapolation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::vector<sequence_entry<T>> s;
    s.reserve(51);
    for (int n = 10; n <= 60; ++n) {
        s.push_back({n, T(2 + T(3) / n - T(5) / (n * n))});
    }
    const auto limit = neville_limit(s);
    // Column 2 with steps 1: (60^2/2)^2 at most, with steps 2 a quarter of that; measured much less.
    CHECK_THAT(limit.value, near(T(2), 4000));
    CHECK(limit.removed >= 2);
    const auto fit = fitted_limit(s);
    // Values at u = -3 of polynomials bounded by 1 on [-1, 1]: up to 577, and as much again in the normal equations.
    CHECK_THAT(fit.value, near(T(2), 20000));
}

TEMPLATE_LIST_TEST_CASE("fits see through what oscillates about a power law", "[convergence][extrapolation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    using std::cos;
    std::vector<sequence_entry<T>> s;
    s.reserve(381);
    for (int n = 20; n <= 400; ++n) {
        s.push_back({n, T(1 + T(1) / n + cos(T(n)) / (n * n))});
    }
    const auto fit = fitted_limit(s);
    const auto table = neville_limit(s);
    CHECK(abs(T(fit.value - 1)) <= fit.uncertainty * 2);
    CHECK(abs(T(table.value - 1)) <= table.uncertainty * 2);
    CHECK(extrapolated_limit(s).uncertainty <= table.uncertainty);
    CHECK_THROWS_AS(neville_limit(std::vector<sequence_entry<T>>{{1, T(1)}}), libration::error);
    CHECK_THROWS_AS(fitted_limit(std::vector<sequence_entry<T>>{{1, T(1)}}), libration::error);
}

}  // namespace convergence_extrapolation_test
