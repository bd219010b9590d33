#include "libration/convergence/test/six_term_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_six_term_test_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the six-term test is exact for a pair of any exponent", "[convergence][six_term_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T cosine = T(3) / 10;
    for (const int thirds : {-8, -3, -1, 1, 4}) {
        const T nu = T(thirds) / 3;
        const auto e = six_term_test(every_coefficient(gegenbauer_series(cosine, nu, 60)));
        REQUIRE(e.radius);
        // The equations tell c_k from n c_k over four steps only: condition about n^2.
        CHECK_THAT(*e.radius, near(T(1), 8 * 60 * 60));
        CHECK_THAT(e.position->re, near(cosine, 8 * 60 * 60, T(1)));
        CHECK_THAT(*e.exponent, near(nu, 8 * 60 * 60 * 60, T(1)));
        CHECK(covers(e, T(1)));
        CHECK(e.count == 2);
    }
}

TEMPLATE_LIST_TEST_CASE("the six-term test finds a pair in a power of x and refuses more than a pair",
                        "[convergence][six_term_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto a = power_series<T>::zero(120);
    const auto inner = gegenbauer_series(T(T(3) / 5), T(-1), 60);
    for (int k = 0; k <= 60; ++k) {
        a[2 * k] = inner[k];
    }
    const auto e = six_term_test(strided_series<T>(a, 0, 2));
    REQUIRE(e.radius);
    // cos(2 phi) = 3/5: the root of least argument is (2 + i)/sqrt(5), of imaginary part half the real one.
    CHECK_THAT(T(e.position->im * 2), near(e.position->re, 8 * 60 * 60));
    CHECK(e.count == 4);
    auto three = gegenbauer_series(T(T(3) / 10), T(-1), 60);
    for (int n = 0; n <= 60; ++n) {
        three[n] += 1;
    }
    // Three singularities on the circle make results that differ, in some steps by real roots; arcsin in t^2 has one
    // alone.
    CHECK_FALSE(six_term_test(every_coefficient(three)).radius);
    auto arcsine = power_series<T>::zero(60);
    arcsine[0] = T(1);
    for (int k = 1; k <= 60; ++k) {
        arcsine[k] = arcsine[k - 1] * (2 * k - 1) * (2 * k - 1) / (2 * k * (2 * k + 1));
    }
    CHECK(six_term_test(every_coefficient(arcsine)).note.find("its roots are real") == 0);
    CHECK(six_term_test(every_coefficient(power_series<T>::zero(60))).note.find("its equations are singular") == 0);
}

TEMPLATE_LIST_TEST_CASE("the six-term test gives a finite answer or a reason on any list",
                        "[convergence][six_term_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(six_term_test(every_coefficient(a))));
    }
}

}  // namespace convergence_six_term_test_test
