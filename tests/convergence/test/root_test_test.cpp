#include "libration/convergence/test/root_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_root_test_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEST_CASE("the root test is right about a geometric series and refuses too short ones", "[convergence][root_test]") {
    // a_n = 2^-n has the radius 2 exactly, whatever n.
    auto geometric = power_series<mpfr>::zero(20);
    const precision_scope scope(40);
    for (int n = 0; n <= 20; ++n) {
        geometric[n] = ldexp(mpfr(1), -n);
    }
    CHECK_THAT(radius_by_root_test(geometric), near(mpfr(2), 4));
    CHECK_THROWS_AS(radius_by_root_test(power_series<double>({1, 2, 3, 4})), libration::error);
    CHECK_THROWS_AS(radius_by_root_test(power_series<double>::zero(8)), libration::error);
}

TEMPLATE_LIST_TEST_CASE("root tests are exact for a geometric series and cover a logarithm", "[convergence][root_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto geometric = binomial_series(T(3), T(-1), 60);
    // An exponential of a logarithm of size 60 log 3, divided by 60.
    CHECK_THAT(*root_test(every_coefficient(geometric)).radius, near(T(3), 8));
    auto logarithm = power_series<T>::zero(60);
    for (int n = 1; n <= 60; ++n) {
        logarithm[n] = T(-1) / n;
    }
    const auto plain = root_test(every_coefficient(logarithm));
    CHECK(covers(plain, T(1)));
    // The correction is exact here: |n a_n| = 1.
    CHECK_THAT(*corrected_root_test(every_coefficient(logarithm)).radius, near(T(1), 8));
    CHECK(root_test(every_coefficient(power_series<T>::zero(60))).note.find("needs 6 non-zero") == 0);
}

TEMPLATE_LIST_TEST_CASE("root tests take the coefficients that a lacunary series has", "[convergence][root_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto a = power_series<T>::zero(200);
    for (int n = 1; n <= 128; n *= 2) {
        a[n] = T(1);
    }
    CHECK_THAT(*root_test(every_coefficient(a)).radius, near(T(1), 4));
    CHECK(covers(corrected_root_test(every_coefficient(a)), T(1)));
}

TEMPLATE_LIST_TEST_CASE("the root test gives a finite answer or a reason on any list", "[convergence][root_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(root_test(every_coefficient(a))));
    }
}

TEMPLATE_LIST_TEST_CASE("the corrected root test gives a finite answer or a reason on any list",
                        "[convergence][corrected_root_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(corrected_root_test(every_coefficient(a))));
    }
}

}  // namespace convergence_root_test_test
