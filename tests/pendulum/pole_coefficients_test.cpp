#include "libration/pendulum/pole_coefficients.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "scalars.hpp"
#include "typed.hpp"

using namespace libration;
using namespace libration::tests;

TEST_CASE("coefficients by poles are those of the recurrence", "[pole_coefficients]") {
    const precision_scope precision(40);
    for (const std::string gap : {"1.99", "1", "1e-1", "1e-6", "1e-12", "-1e-12", "-1e-3", "-2", "-100"}) {
        const auto d = descent_of<mpfr>(with_gap(gap));
        const int order = 700;
        const auto by_poles = descent_series_by_poles(d, order);
        const auto by_recurrence = descent_series(d, order);
        REQUIRE(by_poles.order() == order);
        const mpfr radius = sqrt(1 + pow(singularity_height(d.o) / d.effective_period, 2));
        mpfr scale = 1;
        for (int n = 1; n <= order; ++n) {
            scale /= radius;
            INFO("gap " << gap << ", n = " << n);
            // n epsilon for the powers; the recurrence loses no more (20 bits by N = 4000).
            CHECK(abs(by_poles[n] - by_recurrence[n]) <= scale * 8 / n * epsilon<mpfr>() * (8 * order));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the fixed scalars have them too", "[pole_coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto d = descent_of<T>(with_energy("1.71"));
    const int order = 4 * static_cast<int>(decimal_digits(digits<T>())) + 90;
    const auto by_poles = descent_series_by_poles(d, order);
    const auto by_recurrence = descent_series(d, order);
    const T radius_squared =
        1 + singularity_height(d.o) * singularity_height(d.o) / d.effective_period / d.effective_period;
    T scale(1);
    for (int n = 2; n <= order; n += 2) {
        scale /= radius_squared;
        INFO(n);
        using std::abs;
        CHECK(abs(by_poles[n] - by_recurrence[n]) <= scale * 8 / n * epsilon<T>() * (8 * order));
    }
}

TEST_CASE("a low order is that of the recurrence alone", "[pole_coefficients]") {
    const auto d = descent_of<double>(with_energy("2.02"));
    const auto by_poles = descent_series_by_poles(d, 20);
    const auto by_recurrence = descent_series(d, 20);
    CHECK(by_poles.coefficients() == by_recurrence.coefficients());
}
