// Amplitudes of singularities against the functions that have them.
#include <catch2/catch.hpp>

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

TEST_CASE("several singularities on the circle have no single amplitude", "[convergence][amplitude]") {
    const precision_scope scope(180);
    constexpr int n = 60;
    const auto two = verdict_of(power_at(mpfr(2), mpfr(mpfr(1) / 3), n) + power_at(mpfr(-2), mpfr(mpfr(-1) / 3), n));
    CHECK(two.ring.size() == 2);
    CHECK_FALSE(two.amplitude);
}

}  // namespace convergence_amplitude_test
