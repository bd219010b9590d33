#include "libration/convergence/test/pole_test.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "libration/convergence/test/differential_approximants.hpp"
#include "scalars.hpp"

namespace convergence_pole_test_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

// The true radius lies within the uncertainty, and that is no larger than so many units of rounding.
template <class T>
void check_radius(const radius_estimate<T>& found, const T& radius, int most_units) {
    using std::abs;
    INFO(found.method << ": " << found.note);
    REQUIRE(found.radius);
    CHECK(abs(T(*found.radius - radius)) <= found.uncertainty);
    CHECK(found.uncertainty <= epsilon<T>() * radius * most_units);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the pole test finds the nearest of three poles", "[convergence][pole_test]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto found = pole_test(strided_series<T>(three_poles<T>(60), 0, 1));
    // Each coefficient carries up to N roundings of the powers, the root the difference of two of them.
    check_radius<T>(found, T(5) / 4, 2000);
    CHECK(found.position->im == 0);
    CHECK(found.position->re == *found.radius);
    CHECK(found.count == 1);
    CHECK(*found.exponent == -1);
}

TEMPLATE_LIST_TEST_CASE("a pair of logarithms is a pair of poles of the derivative", "[convergence][pole_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    const auto found = pole_test_of_derivative(strided_series<T>(logarithms_of_a_pair<T>(50), 0, 1));
    check_radius<T>(found, T(5) / 4, 5000);
    CHECK(abs(T(found.position->re - T(3) / 4)) <= found.uncertainty * 2);
    CHECK(abs(T(found.position->im - 1)) <= found.uncertainty * 2);
    CHECK(found.count == 2);
    CHECK(*found.exponent == 0);
}

TEMPLATE_LIST_TEST_CASE("in powers of a power the singularities are all roots", "[convergence][pole_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::sqrt;
    // x h(x^2), h with its pole at 5/4: singular at +-sqrt(5/4).
    const auto poles = pole_test(strided_series<T>(spread(three_poles<T>(60), 1, 2), 1, 2));
    check_radius<T>(poles, sqrt(T(5) / 4), 2000);
    CHECK(poles.count == 2);
    // h = (1 + 4 w/5)^(1/3) in w = x^4: singular at (5/4)^(1/4) e^(i pi/4) and its three turns.
    const auto h = power_at<T>(T(-5) / 4, T(1) / 3, 40);
    const auto branches = differential_approximants(strided_series<T>(spread(h, 0, 4), 0, 4));
    check_radius<T>(branches, sqrt(T(sqrt(T(T(5) / 4)))), 1000000);
    CHECK(branches.count == 4);
    CHECK_THAT(branches.position->re, near<T>(branches.position->im, 16));
}

TEMPLATE_LIST_TEST_CASE("differential approximants give the exponent of a power", "[convergence][pole_test]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    for (const T& nu : {T(T(1) / 3), T(T(-5) / 2), T(T(3) / 2), T(-2), T(-1)}) {
        const strided_series<T> c(power_at<T>(T(-5) / 4, nu, 60), 0, 1);
        for (const auto& found : {differential_approximants(c), second_order_approximants(c)}) {
            // A fit that is exact in degree 1 takes differences of neighbours: N^2 roundings, and N^3 in second order.
            check_radius<T>(found, T(5) / 4, 4000000);
            CHECK(found.position->re == T(-*found.radius));
            CHECK(abs(T(*found.exponent - nu)) <= found.exponent_uncertainty);
            CHECK(found.exponent_uncertainty <= epsilon<T>() * 400000000);
            CHECK(found.count == 1);
        }
    }
}

TEST_CASE("a test whose assumption is wrong is uncertain", "[convergence][pole_test]") {
    // A logarithm is no pole, a cube root no logarithm: the tests converge like 1/N, and say so.
    const precision_scope scope(40);
    const strided_series<mpfr> roots(power_at<mpfr>(mpfr(1), mpfr(1) / 3, 100), 0, 1);
    const strided_series<mpfr> logarithms(logarithms_of_a_pair<mpfr>(100), 0, 1);
    for (const auto& [found, radius] : {std::pair{pole_test(roots), mpfr(1)},
                                        {pole_test_of_derivative(roots), mpfr(1)},
                                        {pole_test(logarithms), mpfr(mpfr(5) / 4)}}) {
        INFO(found.method);
        REQUIRE(found.radius);
        const mpfr error = abs(*found.radius - radius);
        CHECK(error > radius / 100000);
        CHECK(error <= found.uncertainty);
        // A safety of 4, 3 for the assumed exponent, and 2 times 4 for the power of 1/N that the error falls with.
        CHECK(found.uncertainty < error * (2 * 96));
    }
}

TEST_CASE("too few coefficients are told", "[convergence][pole_test]") {
    const strided_series<double> c(power_series<double>({1, 1, 1, 1, 1}), 0, 1);
    CHECK_FALSE(pole_test(c).radius);
    CHECK(pole_test(c).note == "needs 6 non-zero coefficients, there are 5");
    CHECK(differential_approximants(c).note == "needs 8 non-zero coefficients, there are 5");
    CHECK(second_order_approximants(c).note == "needs 10 non-zero coefficients, there are 5");
}

}  // namespace convergence_pole_test_test
