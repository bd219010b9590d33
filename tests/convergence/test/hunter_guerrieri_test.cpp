#include "libration/convergence/test/hunter_guerrieri.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_hunter_guerrieri_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the method of Hunter and Guerrieri is exact for a pair of any exponent",
                        "[convergence][hunter_guerrieri]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T cosine = T(3) / 10;
    for (const int thirds : {-8, -2, -1, 1, 4}) {
        const T nu = T(thirds) / 3;
        const auto e = hunter_guerrieri(every_coefficient(gegenbauer_series(cosine, nu, 60)));
        REQUIRE(e.radius);
        // The determinant tells c_k from n c_k over three steps only: condition about n^2.
        CHECK_THAT(*e.radius, near(T(1), 8 * 60 * 60));
        CHECK_THAT(e.position->re, near(cosine, 8 * 60 * 60, T(1)));
        CHECK_THAT(*e.exponent, near(nu, 8 * 60 * 60 * 60, T(1)));
        CHECK(covers(e, T(1)));
        CHECK(e.count == 2);
    }
}

TEMPLATE_LIST_TEST_CASE("the method of Hunter and Guerrieri refuses a single singularity",
                        "[convergence][hunter_guerrieri]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_FALSE(hunter_guerrieri(every_coefficient(binomial_series(T(1), T(T(1) / 3), 100))).radius);
    CHECK_FALSE(hunter_guerrieri(every_coefficient(binomial_series(T(1), T(-1), 100))).radius);
}

TEMPLATE_LIST_TEST_CASE("the method of Hunter and Guerrieri gives a finite answer or a reason on any list",
                        "[convergence][hunter_guerrieri]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(hunter_guerrieri(every_coefficient(a))));
    }
}

}  // namespace convergence_hunter_guerrieri_test
