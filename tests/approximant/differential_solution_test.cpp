// Solutions of the equations of differential approximants along the real axis, against closed forms.
#include "libration/approximant/differential_solution.hpp"

#include <catch2/catch.hpp>

#include "../studies/population/known_values.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace approximant_differential_solution_test {

using namespace libration;
using namespace libration::tests;

namespace {

constexpr int order = 24;
constexpr long bits = 512;

std::vector<std::optional<mpfr>> values_of(const coefficients& a, const differential_track& track,
                                           const std::vector<mpfr>& targets) {
    const auto relation = relation_of(a, track, order, bits);
    REQUIRE(relation);
    return solution_along_axis(*relation, a, order, targets);
}

void check_near(const std::optional<mpfr>& value, const mpfr& truth) {
    REQUIRE(value);
    CHECK(abs(mpfr(*value / truth - 1)) < mpfr("1e-50"));
}

}  // namespace

TEST_CASE("a power times an exponential is continued to the left of its singularity", "[approximant][differential]") {
    const precision_scope scope(160);
    const mpfr nu = mpfr(-7) / 3;
    const auto power = power_of(polynomial({mpfr(1), mpfr(-1)}, order), nu);
    const auto a = product_of(power, exponential_of(polynomial({mpfr(0), mpfr(1) / 2}, order)));
    const std::vector<mpfr> targets{mpfr(-1) / 8, mpfr(-3), mpfr(-40)};
    const auto values = values_of(a, {1, 1, 0}, targets);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        check_near(values[i], exp(mpfr(log(mpfr(1 - targets[i])) * nu + targets[i] / 2)));
    }
}

TEST_CASE("there is no value at and beyond a singularity on the axis", "[approximant][differential]") {
    const precision_scope scope(160);
    const auto a = power_of(polynomial({mpfr(1), mpfr(-1)}, order), mpfr(1) / 3);
    const auto values = values_of(a, {1, 0, 0}, {mpfr(9) / 10, mpfr(1), mpfr(3) / 2});
    check_near(values[0], exp(mpfr(log(mpfr(1) / 10) / 3)));
    CHECK(!values[1]);
    CHECK(!values[2]);
}

TEST_CASE("an equation of the second order passes between a pair of singularities", "[approximant][differential]") {
    const precision_scope scope(160);
    // log(1 - x + x^2): singular at exp(+-i pi/3).
    const auto a = logarithm_of(polynomial({mpfr(1), mpfr(-1), mpfr(1)}, order));
    const std::vector<mpfr> targets{mpfr(1) / 3, mpfr(2), mpfr(30)};
    const auto values = values_of(a, {2, 1, 0}, targets);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        check_near(values[i], log(mpfr(targets[i] * targets[i] - targets[i] + 1)));
    }
}

}  // namespace approximant_differential_solution_test
