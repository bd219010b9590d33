// The lists for radius tests compared with the exact solution, and their ratios with theory.
#include "libration/pendulum/series_on_arc.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/convergence/coefficient_ratios.hpp"
#include "scalars.hpp"

namespace pendulum_series_on_descent_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::convergence;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the list about a point sums to the exact solution next to it", "[pendulum][series_on_descent]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const mpfr rounding = widen(epsilon<T>());
    for (const char* const energy : {"1/2", "1", "171/100", "202/100", "4"}) {
        for (const rational& x : {rational(0), rational(1) / 3, rational(1) / 2, rational(1)}) {
            INFO("E = " << energy << ", x = " << x.str());
            const motion m = motion::of_energy(rational(energy));
            // 1/8 unit further, 9/64 of a radius: the omitted terms are (9/64)^130 = 2e-111.
            const auto list = series_on_arc<T>(m, x, 130, rational(9) / 8);
            T sum(0);
            for (int n = 130; n >= 0; --n) {
                sum = sum / 8 + list.scaled[n];
            }
            const precision_scope more(decimal_digits(digits<T>()) + 30);
            const auto cover = coverage_from<mpfr>(m, x);
            const mpfr away = cover.place.offset + widen(list.unit) / 8;
            const mpfr expected = exact_solution<mpfr>(m).at({cover.place.quarter, away, away > 0 ? 1 : -1}).theta;
            // Coefficients of size 1 at most after the first, which is below 2 pi: an ulp of the sum and of a_0 each,
            // and that of the unit in a_1.
            CHECK(abs(widen(sum) - expected) <= rounding * 16);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the unit is as many radii as asked", "[pendulum][series_on_descent]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // E = 1: R = T* sqrt 2 about the top, T* about the bottom.
    const motion m = motion::of_energy(1);
    const T top = series_on_arc<T>(m, 0, 1).unit;
    const T bottom = series_on_arc<T>(m, 1, 1, rational(9) / 8).unit;
    CHECK_THAT(T(top * top * 81), near(T(bottom * bottom * 128), 8));
}

TEST_CASE("ratios run to their limit along the line of a logarithm, or scatter", "[pendulum][series_on_descent]") {
    const precision_scope scope(40);
    const auto late_ratios = [](const char* energy, const rational& x, int first, int power) {
        const auto list = series_on_arc<mpfr>(motion::of_energy(rational(energy)), x, 160);
        auto all = ratios_of(strided_series<mpfr>(list.scaled, first, power));
        all.erase(all.begin(), all.end() - 20);
        return all;
    };
    const auto limit = [](const char* energy, const rational& x, int power) {
        return limit_of_ratios(motion::of_energy(rational(energy)), x, power);
    };
    for (const char* const energy : {"1/2", "1", "171/100", "202/100", "4"}) {
        CHECK(limit(energy, 1, 2) == -1);
        CHECK_FALSE(limit(energy, 1, 1).has_value());
        CHECK_FALSE(limit(energy, rational(1) / 2, 1).has_value());
        for (const auto& ratio : late_ratios(energy, 1, 1, 2)) {
            // The next singularities add (R/R2)^118 at most, R/R2 = 0.55 at E = 1/2.
            CHECK(abs(ratio.value + 1 - mpfr(2) / ratio.n) < mpfr("1e-28"));
        }
    }
    CHECK(limit("1", 0, 4) == -1);
    CHECK_FALSE(limit("1", 0, 2).has_value());
    for (const auto& ratio : late_ratios("1", 0, 2, 4)) {
        // The next are at 3 T* + i K~': 5^(-80/2).
        CHECK(abs(ratio.value + 1 - mpfr(4) / ratio.n) < mpfr("1e-25"));
    }
    CHECK_FALSE(limit("171/100", 0, 2).has_value());
    const auto scattered = late_ratios("171/100", 0, 0, 2);
    mpfr least = scattered[0].value;
    mpfr largest = least;
    for (const auto& ratio : scattered) {
        least = std::min(least, ratio.value);
        largest = std::max(largest, ratio.value);
    }
    CHECK(largest - least > 3);
}

TEST_CASE("the nearest singularity is R away, and there are four about the top", "[pendulum][series_on_descent]") {
    const precision_scope scope(40);
    for (const char* const energy : {"1/2", "202/100"}) {
        for (const rational& x : {rational(0), rational(1) / 3, rational(1)}) {
            const auto cover = coverage_from<mpfr>(motion::of_energy(rational(energy)), x);
            CHECK_THAT(modulus_of(nearest_on_arc(cover, x)), near(cover.radius, 4));
        }
    }
    CHECK(nearest_count_on_arc(0) == 4);
    CHECK(nearest_count_on_arc(rational(1) / 3) == 2);
    CHECK(nearest_count_on_arc(1) == 2);
}

TEST_CASE("there is no list at rest, on the separatrix, or of a negative order", "[pendulum][series_on_descent]") {
    CHECK_THROWS_AS(series_on_arc<double>(motion::of_energy(0), 0, 4), libration::error);
    CHECK_THROWS_AS(series_on_arc<double>(motion::of_energy(2), 1, 4), libration::error);
    CHECK_THROWS_AS(series_on_arc<double>(motion::of_energy(1), 1, -1), libration::error);
}

}  // namespace pendulum_series_on_descent_test
