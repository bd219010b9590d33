#include "libration/convergence/test/mercer_roberts.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_mercer_roberts_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("Mercer and Roberts' plot is a constant for a pair of simple poles",
                        "[convergence][mercer_roberts]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T cosine = T(-7) / 20;
    const auto e = mercer_roberts(every_coefficient(gegenbauer_series(cosine, T(-1), 60)));
    REQUIRE(e.radius);
    // D_k is a difference of products about 1 with sin^2(phi) = 0.88; the coefficients carry some 60 roundings each.
    CHECK_THAT(*e.radius, near(T(1), 16 * 60));
    CHECK_THAT(e.position->re, near(cosine, 16 * 60, T(1)));
    CHECK_THAT(*e.exponent, near(T(-1), 16 * 60 * 60, T(1)));
    CHECK(covers(e, T(1)));
    CHECK(e.count == 2);
}

TEMPLATE_LIST_TEST_CASE("Mercer and Roberts' plot covers its error for other exponents",
                        "[convergence][mercer_roberts]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    for (const int thirds : {-8, -1, 1, 4}) {
        const auto e = mercer_roberts(every_coefficient(gegenbauer_series(T(T(1) / 10), T(T(thirds) / 3), 200)));
        CHECK(covers(e, T(1)));
        CHECK(e.uncertainty * 200 < 1);
        CHECK(abs(T(*e.exponent - T(thirds) / 3)) <= e.exponent_uncertainty);
    }
}

TEMPLATE_LIST_TEST_CASE("Mercer and Roberts' plot refuses a single singularity", "[convergence][mercer_roberts]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_FALSE(mercer_roberts(every_coefficient(binomial_series(T(1), T(T(1) / 3), 100))).radius);
    CHECK_FALSE(mercer_roberts(every_coefficient(binomial_series(T(1), T(T(-5) / 2), 100))).radius);
    CHECK_FALSE(mercer_roberts(every_coefficient(binomial_series(T(1), T(-1), 100))).radius);
}

TEMPLATE_LIST_TEST_CASE("Mercer and Roberts' plot gives a finite answer or a reason on any list",
                        "[convergence][mercer_roberts]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(mercer_roberts(every_coefficient(a))));
    }
}

}  // namespace convergence_mercer_roberts_test
