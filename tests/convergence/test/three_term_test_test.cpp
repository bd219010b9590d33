#include "libration/convergence/test/three_term_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_three_term_test_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the three-term test is exact for one singularity of any exponent",
                        "[convergence][three_term_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const int thirds : {-8, -3, -1, 1, 4}) {
        const T nu = T(thirds) / 3;
        const auto e = three_term_test(every_coefficient(binomial_series(T(-2), nu, 60)));
        REQUIRE(e.radius);
        // Three roundings in every ratio, times n = 60 in the difference; in nu once more times n.
        CHECK_THAT(*e.radius, near(T(2), 8 * 60));
        CHECK_THAT(*e.exponent, near(nu, 8 * 60 * 60, T(1)));
        CHECK(e.position->re < 0);
        CHECK(covers(e, T(2)));
        CHECK(e.count == 1);
    }
}

TEMPLATE_LIST_TEST_CASE("the three-term test refuses a pair", "[convergence][three_term_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto e = three_term_test(every_coefficient(gegenbauer_series(T(T(3) / 10), T(-1), 60)));
    CHECK_FALSE(e.radius);
    CHECK(e.note.find("more than one singularity") != std::string::npos);
}

TEMPLATE_LIST_TEST_CASE("the three-term test gives a finite answer or a reason on any list",
                        "[convergence][three_term_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(three_term_test(every_coefficient(a))));
    }
}

}  // namespace convergence_three_term_test_test
