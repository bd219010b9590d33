#include "libration/pendulum/period.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_period_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
T period_of(const motion& m) {
    return effective_period(energy_level_of<T>(m)) * quarters_per_period(m.regime());
}

// Relative error of T*: k' is correct to 2 ulps, dlog K/dlog k' is below 1, the mean of K stops within an ulp, and pi,
// the quotients and the rate add their roundings.
constexpr long period_ulps = 4;

// Exactly sum_{n=0}^{N} ((2n)!/n!^2)^2 16^-n k^(2n), or of 1/(2n+1) k^(2n).
rational binomial_sum(const rational& parameter, int order) {
    rational term = 1;
    rational sum = 1;
    for (int n = 1; n <= order; ++n) {
        term *= rational((2 * n - 1) * (2 * n - 1), 4 * n * n) * parameter;
        sum += term;
    }
    return sum;
}
rational artanh_sum(const rational& parameter, int order) {
    rational power = 1;
    rational sum = 1;
    for (int n = 1; n <= order; ++n) {
        power *= parameter;
        sum += power / (2 * n + 1);
    }
    return sum;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("150 degrees take sqrt 3 times as long as 30 degrees", "[period]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    const T small = period_of<T>(with_state("30deg", "0"));
    const T large = period_of<T>(with_state("150deg", "0"));
    CHECK_THAT(large, near<T>(T(sqrt(T(3)) * small), period_ulps));
}

TEMPLATE_LIST_TEST_CASE("rotation at E is libration at 4/E in slower time", "[period]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    for (const std::string energy : {"4", "10", "2.02", "1e6", "2.000000000000000000000000000001"}) {
        INFO(energy);
        const T fast = effective_period(energy_level_of<T>(with_energy(energy)));
        const T slow = effective_period(energy_level_of<T>(motion::of_energy(rational(4 / fraction(energy)))));
        CHECK_THAT(T(fast * sqrt(from_rational<T>(rational(fraction(energy) / 2)))), near<T>(slow, 2));
    }
}

TEMPLATE_LIST_TEST_CASE("the period of 90 degrees is Gamma(1/4)^2/sqrt(pi)", "[period]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    expected_value expected;
    {
        const precision_scope wide(220);
        mpfr gamma = mpfr(1) / 4;
        mpfr_gamma(handle(gamma), handle(gamma), MPFR_RNDN);
        expected = {gamma * gamma / sqrt(pi<mpfr>()), mpfr(0)};
    }
    CHECK_THAT(period_of<T>(with_state("90deg", "0")), near<T>(expected, period_ulps));
    CHECK_THAT(period_of<T>(with_energy("1")), near<T>(expected, period_ulps));
}

TEMPLATE_LIST_TEST_CASE("at E = 0 the period is 2 pi", "[period]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto o = energy_level_of<T>(with_energy("0"));
    CHECK_THAT(T(effective_period(o) * 4), near<T>(T(pi<T>() * 2), 1));  // the mean of 1 and 1 is exact
    CHECK_THROWS_AS(singularity_height(o), libration::error);
}

TEMPLATE_LIST_TEST_CASE("the period is infinite at E = 2", "[period]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(period_of<T>(with_energy("2")), libration::error);
    CHECK_THROWS_AS(period_of<T>(with_state("180deg", "0")), libration::error);
}

TEMPLATE_LIST_TEST_CASE("periods agree with the table", "[period][reference]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& row : reference_table("motions.csv")) {
        if (row.at("period") == "inf") {
            continue;
        }
        const motion m = motion_of(row);
        INFO(row.at("energy") << row.at("gap") << " " << row.at("theta0") << " " << row.at("omega0"));
        const T effective = effective_period(energy_level_of<T>(m));
        CHECK_THAT(effective, near<T>(decimal(row.at("tstar")), period_ulps));
        CHECK_THAT(T(effective * quarters_per_period(m.regime())), near<T>(decimal(row.at("period")), period_ulps));
    }
}

TEMPLATE_LIST_TEST_CASE("partial sums of both series of K are the sums of fractions that they stand for", "[period]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "1.9998"}) {
        for (const int order : {0, 1, 2, 10, 40}) {
            INFO("E = " << energy << ", N = " << order);
            const rational parameter = fraction(energy) / 2;
            expected_value old_sum;
            expected_value new_sum;
            {
                const precision_scope wide(220);
                const mpfr k = sqrt(from_rational<mpfr>(parameter));
                const mpfr binomials = from_rational<mpfr>(binomial_sum(parameter, order)) * pi<mpfr>() / 2;
                const mpfr artanhs = from_rational<mpfr>(artanh_sum(parameter, order));
                old_sum = {binomials, mpfr(0)};
                new_sum = {binomials - artanhs + atanh(k) / k, mpfr(0)};
            }
            const auto o = energy_level_of<T>(with_energy(energy));
            // Half an ulp per sum, of random sign, as long as the decreasing terms change it.
            CHECK_THAT(effective_period_series(o, order), near<T>(old_sum, 3 + order / 4));
            CHECK_THAT(effective_period_resummed(o, order), near<T>(new_sum, 3 + order / 4));
        }
    }
    CHECK_THROWS_AS(effective_period_series(energy_level_of<T>(with_energy("1")), -1), libration::error);
    CHECK_THROWS_AS(effective_period_resummed(energy_level_of<T>(with_energy("1")), -1), libration::error);
}

}  // namespace pendulum_period_test
