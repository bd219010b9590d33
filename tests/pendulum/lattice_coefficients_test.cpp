// The sums over singularities compared with the recurrence, with which they share only the motion.
#include "libration/pendulum/lattice_coefficients.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/resummation.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace pendulum_lattice_coefficients_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::vector<named_motion> motions() {
    return {{"E = 1e-6", with_energy("1e-6")},
            {"E = 0.5", with_energy("0.5")},
            {"E = 1", with_energy("1")},
            {"E = 1.71", with_energy("1.71")},
            {"E = 1.9998", with_energy("1.9998")},
            {"gap 1e-20", with_gap("1e-20")},
            {"gap -1e-20, clockwise", with_gap("-1e-20", -1)},
            {"E = 2.02", with_energy("2.02")},
            {"E = 4", with_energy("4")},
            {"E = 100, clockwise", with_energy("100", -1)},
            {"from (-50, -3)", with_state("-50", "-3")},
            {"falling from (1, -0.5)", with_state("1", "-0.5")}};
}

const std::vector<std::string> points{"top", "bottom", "start", "T/8"};

// At E = 2: about the bottom, before and after it.
const std::vector<std::string> critical_points{"bottom", "-0.7", "3"};

void compare_on_balls(const named_motion& from, const std::string& at, int order) {
    INFO(from.name << " about " << at);
    const exact_solution<ball> solution(from.m);
    const auto point = read_expansion_point(at);
    const auto checked = expand_by(recurrence::symmetric_squares, solution, point, order);
    const auto view = view_from(from.m, phase_of(point, solution));
    REQUIRE(view);
    const long begin = lattice_begins(*view, 0, order);
    REQUIRE(begin < order);
    const auto sums = lattice_coefficients<ball>(from.m, point, checked.scale, order).between(begin, order);
    for (long n = begin; n <= order; ++n) {
        INFO("n = " << n);
        const ball& sum = sums[static_cast<std::size_t>(n - begin)];
        CHECK(overlaps(sum, checked.scaled[static_cast<int>(n)]));
        // In units of 8/n: an eighth of an epsilon for the omitted poles, and the rounding to 20 digits.
        CHECK_FALSE(certainly_less(epsilon<ball>() * 8 / n, radius_of(sum)));
        CHECK((is_exact(sum) && contains_zero(sum)) == !view->powers().has(n));
    }
}

}  // namespace

TEST_CASE("sums over singularities lie on the balls of the recurrence", "[lattice_coefficients][ball]") {
    const precision_scope scope(20);
    for (const auto& from : motions()) {
        for (const std::string& at : points) {
            compare_on_balls(from, at, 160);
        }
    }
    for (const auto& from : critical_motions()) {
        for (const std::string& at : critical_points) {
            compare_on_balls(from, at, 130);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("an expansion is that of the recurrence on both sides of where the sums begin",
                        "[lattice_coefficients]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int order = std::same_as<T, quad> || std::same_as<T, mpfr> ? 230 : 2200;
    for (const std::string at : {"top", "T/8"}) {
        for (const auto& from : {named_motion{"E = 1.71", with_energy("1.71")}, {"E = 4", with_energy("4", -1)}}) {
            INFO(from.name << " about " << at);
            const exact_solution<T> solution(from.m);
            const auto point = read_expansion_point(at);
            const auto view = view_from(from.m, phase_of(point, solution));
            REQUIRE(lattice_begins(*view, 0, order) < order);
            const auto found = expand(solution, point, order);
            const auto checked = expand_by(recurrence::symmetric_squares, solution, point, order);
            REQUIRE(found.scaled.order() == order);
            for (int n = 0; n <= order; ++n) {
                INFO("n = " << n);
                // 4 ulps of the initial value and one per power, of the recurrence.
                CHECK_THAT(found.scaled[n], near<T>(checked.scaled[n], 4 + n, T(T(8) / std::max(n, 1))));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the sums are right to a few ulps, however large the power", "[lattice_coefficients]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::pow;
    // The separatrix has a_n = +-(4/n) (2/pi)^n [1 - 3^-n + ..], R = pi/2: n a_n scale^n/4 = (2 scale/pi)^n.
    const expansion_point bottom{expansion_point::place::bottom, {}};
    const exact_solution<T> solution(with_energy("2"));
    const T scale = *radius_about(solution, bottom);
    for (const long n : {3'001L, 1'000'000'001L, 1'000'000'000'000'001L - 4}) {
        INFO(n);
        const T sum = coefficients_about(solution, bottom, scale, n, n).front();
        mpfr expected;
        {
            const precision_scope wide(decimal_digits(digits<T>()) + 60);
            const mpfr power = exp(mpfr(log(mpfr(widen(scale) * 2 / pi<mpfr>())) * n));
            expected = power * 4 / n * (n % 4 == 1 ? 1 : -1);
        }
        // A power of 3, the first after n = 3001, is omitted far below epsilon; 1/n and the product round.
        CHECK_THAT(sum, near<T>(expected_value{expected, mpfr(0)}, 4));
    }
}

TEST_CASE("a power is the same alone, in a block and in a series", "[lattice_coefficients][ball]") {
    const precision_scope scope(50);
    const motion m = with_energy("1.71");
    const exact_solution<ball> solution(m);
    const auto point = read_expansion_point("1.1");
    const ball scale = midpoint(*radius_about(solution, point));
    const auto series = coefficients_about(solution, point, scale, 0, 700);
    const auto part = coefficients_about(solution, point, scale, 301, 600);
    for (const long n : {301L, 302L, 364L, 365L, 500L, 600L, 700L}) {
        INFO(n);
        const ball alone = coefficients_about(solution, point, scale, n, n).front();
        CHECK(overlaps(alone, series[static_cast<std::size_t>(n)]));
        CHECK_FALSE(certainly_less(epsilon<ball>() * 1000 / n, radius_of(alone)));
        if (n <= 600) {
            CHECK(overlaps(alone, part[static_cast<std::size_t>(n - 301)]));
        }
    }
}

TEST_CASE("the series of the way down is that of the recurrence, clockwise too", "[lattice_coefficients]") {
    const precision_scope scope(40);
    for (const auto& from : {named_motion{"gap 1.99", with_gap("1.99")},
                             {"gap 1e-6", with_gap("1e-6")},
                             {"gap -1e-12, clockwise", with_gap("-1e-12", -1)},
                             {"gap -2", with_gap("-2")},
                             {"falling from (1, -0.5)", with_state("1", "-0.5")}}) {
        INFO(from.name);
        const auto arc = arc_of<mpfr>(from.m);
        const int order = 400;
        const auto found = arc_series(arc, order);
        const auto checked = arc_series(arc, order, recurrence::symmetric_squares);
        REQUIRE(found.order() == order);
        const mpfr ratio = top_bounds<mpfr>::of(arc.level()).rho;
        mpfr unit = 8;
        for (int n = 1; n <= order; ++n) {
            unit *= ratio;
            INFO("n = " << n);
            CHECK_THAT(found[n], near<mpfr>(checked[n], 4 + n, mpfr(unit / n)));
        }
    }
}

TEST_CASE("an equilibrium has a constant theta", "[lattice_coefficients]") {
    const exact_solution<double> solution(with_energy("0"));
    CHECK(coefficients_about(solution, {}, 1., 0, 2) == std::vector<double>{0, 0, 0});
    CHECK(coefficients_about(solution, {}, 1., 1'000'000, 1'000'001) == std::vector<double>{0, 0});
    CHECK_THROWS_AS(lattice_coefficients<double>(with_energy("0"), {}, 1., 10), libration::error);
}

TEST_CASE("powers that are none are refused", "[lattice_coefficients]") {
    const exact_solution<double> solution(with_energy("1"));
    CHECK_THROWS_AS(coefficients_about(solution, {}, 1., -1, 3), libration::error);
    CHECK_THROWS_AS(coefficients_about(solution, {}, 1., 4, 3), libration::error);
    CHECK_THROWS_AS(coefficients_about(solution, {}, 1., 3, largest_power + 1), libration::error);
    CHECK_THROWS_AS(lattice_coefficients<double>(with_energy("1"), {}, 1., 10).between(4, 10), libration::error);
    CHECK_THROWS_AS(lattice_coefficients<double>(with_energy("1"), {}, 1., 10).between(5, 11), libration::error);
}

}  // namespace pendulum_lattice_coefficients_test
