// The uniform resummation compared with the exact solution and with the sum over all columns, rounded and proved.
#include "libration/pendulum/uniform_resummation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "libration/pendulum/uniform_convergence_rate.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace pendulum_uniform_resummation_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// theta and its slope in x on the arc.
jet<mpfr> exact_at(const exact_solution<mpfr>& solution, const mpfr& effective_period, const mpfr& x) {
    const auto state = solution.from_top(x);
    return {state.theta, state.omega * effective_period};
}

constexpr int points = 16;

// The same at the sixteenths of T*.
std::vector<jet<mpfr>> exact_arc(const motion& m, long digits) {
    const precision_scope scope(digits);
    const exact_solution<mpfr> solution(m);
    const mpfr period = effective_period(energy_level_of<mpfr>(m));
    std::vector<jet<mpfr>> all;
    all.reserve(points + 1);
    for (int i = 0; i <= points; ++i) {
        all.push_back(exact_at(solution, period, mpfr(i) / points));
    }
    return all;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("at every energy theta is right to its rounding and the bound", "[uniform_resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : canonical_motions()) {
        for (const int columns : {1, 3}) {
            INFO(name << ", P = " << columns);
            const int order = 32;
            const auto uniform = uniform_from_top<T>(m, order, columns);
            const mpfr bound = widen(uniform.bounds().norm(order));
            const mpfr slope_bound = widen(uniform.bounds().remainder(order, T(1)).slope);
            const std::vector<jet<mpfr>> truth = exact_arc(m, decimal_digits(digits<T>()) + 130);
            const mpfr fastest = abs(truth.back().slope);
            for (int i = 0; i <= points; ++i) {
                const jet<T> at = uniform(T(i) / points);
                const jet<mpfr>& exact = truth[static_cast<std::size_t>(i)];
                // Two tanh or exp and arctangents of at most 2 ulps each for a pair, their sum and the constant's; the
                // whole is below 2 pi.
                const mpfr scale = exact.value > 1 ? exact.value : mpfr(1);
                CHECK_THAT(at.value, near<T>(expected_value{exact.value, bound}, 3 + 2 * columns, scale));
                CHECK_THAT(at.slope, near<T>(expected_value{exact.slope, slope_bound}, 6 * columns, fastest + 1));
            }
        }
    }
}

TEST_CASE("in double sixteen coefficients leave a rounding of theta at every energy", "[uniform_resummation]") {
    mpfr worst(0);
    for (const auto& [name, m] : canonical_motions()) {
        const auto uniform = uniform_from_top<double>(m, m.regime() == regime::rotation ? 31 : 32);
        const precision_scope more(150);
        const exact_solution<mpfr> solution(m);
        for (int i = 0; i <= 200; ++i) {
            const double x = i / 200.0;
            const mpfr theta = solution.from_top(mpfr(x)).theta;
            worst = std::max(worst, mpfr(abs(widen(uniform.value(x)) - theta) / (theta > 1 ? theta : mpfr(1))));
        }
    }
    INFO("largest error over max(1, theta): " << worst << ", measured 1.0e-15");
    CHECK(worst < mpfr("1.4e-15"));  // six roundings of 2^-52
}

TEST_CASE("proved: theta and its slope lie in the balls, at any order", "[uniform_resummation]") {
    const precision_scope precision(50);
    for (const auto& [name, m] : canonical_motions()) {
        for (const int order : {2, 9, 32, 110}) {
            const auto uniform = uniform_from_top<ball>(m, order);
            for (int i = 0; i <= 4; ++i) {
                INFO(name << ", N = " << order << ", x = " << i << "/4");
                const jet<ball> at = uniform(ball(i) / 4);
                const precision_scope more(170);
                const jet<mpfr> exact =
                    exact_at(exact_solution<mpfr>(m), effective_period(energy_level_of<mpfr>(m)), mpfr(i) / 4);
                CHECK(contains(at.value, ball(exact.value)));
                CHECK(contains(at.slope, ball(exact.slope)));
                if (order == 110) {
                    // 3^-111 is 1e-53.
                    CHECK(certainly_less(radius_of(at.value), pow(ball(10), -48)));
                }
            }
        }
    }
    const auto uniform = uniform_from_top<ball>(with_energy("1"), 8);
    CHECK_THROWS_AS(uniform(ball(2)), libration::error);
}

TEST_CASE("theorem U bounds the errors of value and slope, down to a factor of 1.4", "[uniform_resummation]") {
    const precision_scope precision(250);
    mpfr closest(0);
    mpfr closest_slope(0);
    for (const auto& [name, m] : canonical_motions()) {
        const exact_solution<mpfr> solution(m);
        const mpfr period = effective_period(energy_level_of<mpfr>(m));
        for (const int order : {1, 2, 5, 8, 16, 31, 32, 60}) {
            const auto uniform = uniform_from_top<mpfr>(m, order);
            for (const mpfr& x : {mpfr(mpfr(1) / 3), mpfr(mpfr(4) / 5), mpfr(1)}) {
                INFO(name << ", N = " << order << ", x = " << x);
                const jet<mpfr> at = uniform(x);
                const jet<mpfr> exact = exact_at(solution, period, x);
                const jet<mpfr> bound = uniform.bounds().remainder(order, x);
                const mpfr ratio = abs(at.value - exact.value) / bound.value;
                const mpfr slope_ratio = abs(at.slope - exact.slope) / bound.slope;
                CHECK(ratio <= 1);
                CHECK(slope_ratio <= 1);
                closest = std::max(closest, ratio);
                closest_slope = std::max(closest_slope, slope_ratio);
            }
        }
    }
    INFO("largest error over bound: value " << closest << ", slope " << closest_slope);
    CHECK(closest > mpfr("0.7"));  // measured 0.749 for both
    CHECK(closest_slope > mpfr("0.7"));
}

TEMPLATE_LIST_TEST_CASE("extended to all times it is the sum over all columns", "[uniform_resummation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : periodic_motions()) {
        const int order = 2 * static_cast<int>(decimal_digits(digits<T>())) + 4;  // 3^-N is below epsilon
        const periodic_extension<T, uniform_resummation<T>> extended(m, uniform_from_top<T>(m, order));
        const separatrix_sum<T> sum(m);
        const T speed = energy_level_of<T>(m).time_scale * 2;
        for (const std::string time : {"0", "0.1", "1", "-13.5", "7.3", "T/8", "T/4", "-T/2", "7T/9"}) {
            INFO(name << " at " << time);
            using std::abs;
            const jet<T> at = extended(read_exact(time));
            const jet<T> expected = sum(read_exact(time));
            // Six roundings of this route and those of the other [separatrix_sum_test].
            const long allowed = 12 + sum.pairs() / 16;
            CHECK_THAT(at.value, near<T>(expected.value, allowed, T(abs(expected.value) + 1)));
            CHECK_THAT(at.slope, near<T>(expected.slope, allowed, speed));
        }
    }
}

TEST_CASE("next to E = 2 the digits of a short time before the bottom are kept", "[uniform_resummation]") {
    // T* is 116 here: the double 1 - away has lost 1e-14 of theta.
    const motion m = with_gap("1e-100");
    const auto uniform = uniform_from_top<double>(m, 32);
    const double away = 1e-9;
    const precision_scope more(150);
    const mpfr period = effective_period(energy_level_of<mpfr>(m));
    const exact_solution<mpfr> solution(m);
    const mpfr theta = solution.at({integer(2), mpfr(period * -mpfr(away)), -1}).theta;
    CHECK(abs(widen(uniform.before_bottom(away).value) - theta) < abs(theta) * mpfr("1e-15"));
    CHECK(abs(widen(uniform(1 - away).value) - theta) > abs(theta) * mpfr("1e-9"));
}

TEST_CASE("its rate is below 1/3 at every energy, and is that of the coefficients", "[uniform_resummation]") {
    const precision_scope precision(120);
    for (const auto& [name, m] : canonical_motions()) {
        INFO(name);
        const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(m));
        CHECK(uniform_convergence_rate(bounds, 1) < mpfr(1) / 3);
        CHECK(uniform_convergence_rate(bounds, 2) < mpfr(1) / 5);
    }
    // |b_n| is (8/n) |sin(n phi)| rate^n up to further poles: the largest of some, to the power 1/n.
    const auto o = energy_level_of<mpfr>(with_energy("1.71"));
    const auto bounds = top_bounds<mpfr>::of(o);
    const auto rest = uniform_remainder(o.regime, half_column_distance(o), 1, 160);
    mpfr largest(0);
    for (int n = 130; n <= 160; n += 2) {
        largest = std::max(largest, mpfr(abs(rest[n]) * n / 8 / pow(uniform_convergence_rate(bounds, 1), n)));
    }
    CHECK(largest <= mpfr("1.001"));
    CHECK(largest > mpfr("0.9"));
}

TEMPLATE_LIST_TEST_CASE("E = 0, E = 2 and impossible orders are refused", "[uniform_resummation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(uniform_from_top<T>(with_energy("0"), 4), libration::error);
    CHECK_THROWS_AS(uniform_from_top<T>(with_energy("2"), 4), libration::error);
    CHECK_THROWS_AS(uniform_from_top<T>(with_state("pi", "0"), 4), libration::error);
    CHECK_THROWS_AS(uniform_from_top<T>(with_energy("1"), -1), libration::error);
    CHECK_THROWS_AS(uniform_from_top<T>(with_energy("1"), 4, 0), libration::error);
    CHECK(uniform_from_top<T>(with_energy("3"), 0).order() == 0);
    CHECK(uniform_from_top<T>(with_energy("3"), 8).order() == 8);
}

}  // namespace pendulum_uniform_resummation_test
