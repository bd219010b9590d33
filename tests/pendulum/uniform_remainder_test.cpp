// The remainder after the columns, compared with the sum of the Taylor series of every column, and theorem U.
#include "libration/pendulum/uniform_remainder.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "pendulum/arc/column_sums.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace pendulum_column_rest_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// b_n for P = 1 to 140 digits.
power_series<mpfr> exact_rest(const motion& m, int order) {
    const precision_scope more(140);
    const auto o = energy_level_of<mpfr>(m);
    return uniform_remainder(o.regime, half_column_distance(o), 1, order);
}

}  // namespace

TEST_CASE("the rest is the sum over the Taylor series of the columns", "[column_rest]") {
    const precision_scope precision(60);
    for (const std::string energy : {"0.5", "1.71", "1.999999", "2.02", "4"}) {
        const auto o = energy_level_of<mpfr>(with_energy(energy));
        const mpfr y = half_column_distance(o);
        for (const int columns : {1, 2, 3}) {
            INFO("E = " << energy << ", P = " << columns);
            const auto rest = uniform_remainder(o.regime, y, columns, 21);
            const auto sums = column_by_column(o.regime, y, columns, 21);
            for (int n = 1; n <= 21; ++n) {
                // exp(-2 60) ends the columns; both routes lose a few digits where their terms have both signs.
                CHECK(abs(rest[n] - sums[static_cast<std::size_t>(n)]) < mpfr("1e-50"));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the coefficients have the absolute accuracy of their scalar at every energy", "[column_rest]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : canonical_motions()) {
        INFO(name);
        const auto o = energy_level_of<T>(m);
        const auto rest = uniform_remainder(o.regime, half_column_distance(o), 1, 33);
        const auto exact = exact_rest(m, 33);
        for (int n = 0; n <= 33; ++n) {
            INFO("n = " << n);
            // b_n is up to 1/3; y has 4 roundings and is raised to v^n exp(-3 v), whose condition is up to 8.
            // b_0 and b_1 are sums of terms up to 4/(2j+1) with both signs, whose sizes add up to 9 at 1e-20.
            CHECK_THAT(rest[n], near<T>(exactly(exact[n]), 8, T(n < 2 ? 4 : 1)));
        }
    }
}

TEST_CASE("on balls every coefficient is enclosed", "[column_rest]") {
    const precision_scope precision(50);
    for (const auto& [name, m] : canonical_motions()) {
        INFO(name);
        const auto o = energy_level_of<ball>(m);
        const auto rest = uniform_remainder(o.regime, half_column_distance(o), 1, 40);
        const auto exact = exact_rest(m, 40);
        for (int n = 0; n <= 40; ++n) {
            CHECK(contains(rest[n], ball(exact[n])));
            CHECK(certainly_less(radius_of(rest[n]), pow(ball(10), -47)));
        }
    }
}

TEST_CASE("theorem U bounds every coefficient, by a factor down to 1.2", "[column_rest]") {
    const precision_scope precision(80);
    mpfr closest(0);
    for (const auto& [name, m] : canonical_motions()) {
        const auto o = energy_level_of<mpfr>(m);
        for (const int columns : {1, 2, 5}) {
            INFO(name << ", P = " << columns);
            const uniform_bounds<mpfr> bounds{parity_from_top(o.regime), columns};
            const auto rest = uniform_remainder(o.regime, half_column_distance(o), columns, 80);
            for (int n = 2; n <= 80; ++n) {
                const mpfr ratio = abs(rest[n]) / bounds.coefficient(n);
                CHECK(ratio <= 1);
                closest = std::max(closest, ratio);
            }
        }
    }
    INFO("largest |b_n| over its bound: " << closest);
    CHECK(closest > mpfr("0.8"));  // measured 0.856: the bound is sharp
    CHECK(closest < mpfr("0.9"));
}

TEST_CASE("the bound of the remainder is 4.5e-17 for libration and 1.4e-16 for rotation at degree 32",
          "[column_rest]") {
    const precision_scope precision(30);
    const uniform_bounds<mpfr> swing{0, 1};
    const uniform_bounds<mpfr> turn{1, 1};
    CHECK(to_decimal(swing.norm(32), 2) == "4.5e-17");
    CHECK(to_decimal(turn.norm(31), 2) == "1.4e-16");
    CHECK(swing.norm(33) == swing.norm(32));
    // The sum of the bounds of the omitted coefficients, added one by one.
    for (const auto& bounds : {swing, turn, uniform_bounds<mpfr>{0, 3}}) {
        for (const int order : {1, 2, 7, 32}) {
            const mpfr x = mpfr(9) / 10;
            mpfr value(0);
            mpfr slope(0);
            for (int n = bounds.first_omitted(order); n < 400; n += 2) {
                value += bounds.coefficient(n) * pow(x, n);
                slope += bounds.coefficient(n) * pow(x, n - 1) * n;
            }
            const jet<mpfr> bound = bounds.remainder(order, x);
            CHECK(bound.value >= value);
            CHECK(bound.slope >= slope);
            CHECK(bound.value < value * mpfr("1.1"));
            CHECK(bound.slope < slope * mpfr("1.2"));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("where there are no columns, or the theorem says nothing, it is said", "[column_rest]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(half_column_distance(energy_level_of<T>(with_energy("0"))), libration::error);
    CHECK_THROWS_AS(uniform_remainder(regime::libration, T(1), 0, 3), libration::error);
    CHECK_THROWS_AS(uniform_remainder(regime::libration, T(1), 1, -1), libration::error);
    CHECK_THROWS_AS((uniform_bounds<T>{0, 1}.coefficient(1)), libration::error);
    CHECK_THROWS_AS((uniform_bounds<T>{1, 1}.norm(0)), libration::error);  // the first omitted power is 1
    CHECK_NOTHROW(uniform_bounds<T>{0, 1}.norm(0));
}

}  // namespace pendulum_column_rest_test
