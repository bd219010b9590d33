#include "libration/convergence/test/top_line_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_top_line_test_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the top line is exact for a geometric series and covers pairs", "[convergence][top_line_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Logarithms of up to 60 log 3 over a chord of 15.
    CHECK_THAT(*top_line_test(every_coefficient(binomial_series(T(3), T(-1), 60))).radius, near(T(3), 60));
    for (const int fifths : {-4, -2, 1, 3}) {
        const auto e = top_line_test(every_coefficient(gegenbauer_series(T(T(fifths) / 5), T(T(1) / 3), 200)));
        CHECK(covers(e, T(1)));
        CHECK(e.uncertainty * 5 < 1);
    }
}

TEMPLATE_LIST_TEST_CASE("the top line runs along the coefficients that a lacunary series has",
                        "[convergence][top_line_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto a = power_series<T>::zero(200);
    for (int n = 1; n <= 128; n *= 2) {
        a[n] = T(1);
    }
    CHECK_THAT(*top_line_test(every_coefficient(a)).radius, near(T(1), 4));
    CHECK(top_line_test(every_coefficient(power_series<T>::zero(60))).note.find("needs 6 non-zero") == 0);
}

TEMPLATE_LIST_TEST_CASE("the top line gives a finite answer or a reason on any list", "[convergence][top_line_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(top_line_test(every_coefficient(a))));
    }
}

}  // namespace convergence_top_line_test_test
