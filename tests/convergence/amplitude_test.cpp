// Amplitudes of singularities against the functions that have them.
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "../studies/population/radius_families.hpp"
#include "libration/convergence/verdict.hpp"

namespace convergence_amplitude_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::convergence;
using namespace libration::tests::population;

namespace {

list_verdict verdict_of(const power_series<mpfr>& a) {
    series_list list;
    for (const mpfr& each : a.coefficients()) {
        list.values.push_back(each);
    }
    return verdict_on(list);
}

void check_amplitude(const list_verdict& verdict, const mpfr& truth, double asked) {
    REQUIRE(verdict.amplitude);
    const mpfr error = abs(mpfr(verdict.amplitude->value - truth));
    CHECK(error <= verdict.amplitude->uncertainty);
    CHECK(verdict.amplitude->uncertainty < abs(truth) * mpfr(asked));
}

}  // namespace

// e^x (1 - x/2)^(1/3): e^2; -e^x log(1 + x/3): -e^-3; x/(1 - x^2/4) = x/(2 (1 - x/2)) at its positive pole.
TEST_CASE("amplitudes are limits of the functions divided by the singular power", "[convergence][amplitude]") {
    const precision_scope scope(180);
    constexpr int n = 60;
    const auto e = exponential(polynomial({mpfr(0), mpfr(1)}, n));
    check_amplitude(verdict_of(e * power_at(mpfr(2), mpfr(mpfr(1) / 3), n)), exp(mpfr(2)), 1e-5);
    check_amplitude(verdict_of(e * logarithm_at(mpfr(-3), n)), exp(mpfr(-3)), 1e-5);
    check_amplitude(verdict_of(e * power_at(mpfr(-2), mpfr(-1), n)), exp(mpfr(-2)), 1e-5);
    const auto odd = verdict_of(polynomial({mpfr(0), mpfr(1)}, n) *
                                (power_at(mpfr(2), mpfr(-1), n) * power_at(mpfr(-2), mpfr(-1), n)));
    check_amplitude(odd, mpfr(1), 1e-5);
}

// e^x (1 - x)^t + c (1 - x)^s: e. A coefficient divided by that of (1 - x)^t approaches it like n^(t - s): without the terms
// of the second power the amplitude would have one or two digits.
TEST_CASE("two confluent powers have both exponents and the amplitude of the first", "[convergence][amplitude]") {
    const precision_scope scope(180);
    constexpr int n = 60;
    const auto e = exponential(polynomial({mpfr(0), mpfr(1)}, n));
    for (const auto& [c, t, s] :
         {std::tuple{1.0, -1.0, -0.5}, {-3.0, -1.0, -0.5}, {0.125, -1.0, 0.5}, {2.0, 0.25, 0.75}}) {
        const auto verdict = verdict_of(e * power_at(mpfr(1), mpfr(t), n) + mpfr(c) * power_at(mpfr(1), mpfr(s), n));
        CAPTURE(c, t, s);
        CHECK(abs(mpfr(*verdict.radius - 1)) <= verdict.uncertainty);
        REQUIRE(verdict.exponent);
        CHECK(abs(mpfr(*verdict.exponent - t)) <= verdict.exponent_uncertainty);
        CHECK(verdict.exponent_uncertainty < mpfr(1e-20));
        CHECK(verdict.kind == singularity_kind::confluent);
        REQUIRE(verdict.second_exponent);
        CHECK(std::abs(*verdict.second_exponent - s) < 1e-6);
        check_amplitude(verdict, exp(mpfr(1)), 1e-4);
    }
}

TEST_CASE("several singularities on the circle have no single amplitude", "[convergence][amplitude]") {
    const precision_scope scope(180);
    constexpr int n = 60;
    const auto two = verdict_of(power_at(mpfr(2), mpfr(mpfr(1) / 3), n) + power_at(mpfr(-2), mpfr(mpfr(-1) / 3), n));
    CHECK(two.ring.size() == 2);
    CHECK_FALSE(two.amplitude);
}

}  // namespace convergence_amplitude_test
