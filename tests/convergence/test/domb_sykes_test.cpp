#include "libration/convergence/test/domb_sykes.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_domb_sykes_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the intercept and slope of the plot are those of a single singularity",
                        "[convergence][domb_sykes]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // atanh(x/2) in x^2: x0 = 2, nu = 0 at both ends, ratio 1/4 (1 - 2/n), a straight line in 1/n.
    auto a = power_series<T>::zero(121);
    T size(1);
    for (int n = 1; n <= 121; n += 2, size /= 4) {
        a[n] = size / (n * 2);
    }
    const auto e = domb_sykes(strided_series<T>(a, 1, 2));
    REQUIRE(e.radius);
    // Two roundings a ratio; the first column of the table multiplies them by up to 2 n.
    CHECK_THAT(*e.radius, near(T(2), 2 * 2 * 121));
    CHECK_THAT(*e.exponent, near(T(0), 2 * 121 * 121, T(1)));
    CHECK(covers(e, T(2)));
    CHECK(e.count == 2);
}

TEMPLATE_LIST_TEST_CASE("the plot's extrapolated intercept gains many digits over the last ratio",
                        "[convergence][domb_sykes]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // (1 - x)^(1/3) e^x: ratios have all powers of 1/n.
    const auto root = binomial_series(T(1), T(T(1) / 3), 100);
    auto a = power_series<T>::zero(100);
    T factor(1);
    for (int k = 0; k <= 100; ++k) {
        for (int n = k; n <= 100; ++n) {
            a[n] += root[n - k] * factor;
        }
        factor /= k + 1;
    }
    const auto e = domb_sykes(every_coefficient(a));
    REQUIRE(e.radius);
    CHECK(covers(e, T(1)));
    CHECK(e.uncertainty * 10000000 < 1);
    using std::abs;
    CHECK(abs(T(*e.exponent - T(1) / 3)) <= e.exponent_uncertainty);
}

// Corrections in n^(-1/2), which the table in 1/n does not remove: e^(x/(1-x)), whose coefficients are
// (n + 1) a_(n+1) = (2 n + 1) a_n - (n - 1) a_(n-1), and (1-x)^-1 with a branch point at the same place, a_n = 1 + n^(-1/2).
TEMPLATE_LIST_TEST_CASE("the uncertainty of the plot covers essential singularities and confluent branch points",
                        "[convergence][domb_sykes]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    for (const int last : {25, 50, 100, 200, 300}) {
        INFO(last);
        auto essential = power_series<T>::zero(last);
        auto confluent = power_series<T>::zero(last);
        essential[0] = essential[1] = confluent[0] = 1;
        confluent[1] = 2;
        for (int n = 1; n < last; ++n) {
            essential[n + 1] = T(T((2 * n + 1) * essential[n]) - T((n - 1) * essential[n - 1])) / (n + 1);
            confluent[n + 1] = T(1 + 1 / T(sqrt(T(n + 1))));
        }
        for (const auto& a : {essential, confluent}) {
            const auto e = domb_sykes(every_coefficient(a));
            REQUIRE(e.radius);
            CHECK(covers(e, T(1)));
            CHECK(e.uncertainty < T(1) / 4);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the plot refuses scattering ratios and zeros", "[convergence][domb_sykes]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(domb_sykes(every_coefficient(gegenbauer_series(T(0), T(-1), 60))).note.find("divides by 0") == 0);
    CHECK(domb_sykes(every_coefficient(gegenbauer_series(T(T(1) / 2 + T(1) / 9), T(-1), 60))).note.find("the ratios") ==
          0);
}

TEMPLATE_LIST_TEST_CASE("the Domb-Sykes plot gives a finite answer or a reason on any list",
                        "[convergence][domb_sykes]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& a : hostile_series<T>()) {
        CHECK(well_formed(domb_sykes(every_coefficient(a))));
    }
}

}  // namespace convergence_domb_sykes_test
