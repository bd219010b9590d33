// The quotient of thetas compared with the recurrence and the sums over singularities, with which it shares only the
// motion.
#include "libration/pendulum/theta_series.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace pendulum_theta_series_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::vector<named_motion> motions() {
    return {{"E = 1e-20", with_energy("1e-20")},
            {"E = 0.5", with_energy("0.5")},
            {"E = 1", with_energy("1")},
            {"E = 1.71", with_energy("1.71")},
            {"gap 1e-30", with_gap("1e-30")},
            {"gap -1e-30, clockwise", with_gap("-1e-30", -1)},
            {"E = 4", with_energy("4")},
            {"E = 1e6, clockwise", with_energy("1e6", -1)},
            {"falling from (1, -0.5)", with_state("1", "-0.5")}};
}

// On both sides of both symmetric points, in each of the four quarters.
const std::vector<std::string> points{"top", "bottom", "T/8", "-T/7", "3T/8", "5T/9", "7T/8", "1.3"};

const std::vector<std::string> critical_points{"bottom", "0.3", "-0.7", "-20", "1000"};

void compare_on_balls(const named_motion& from, const std::string& at, int order) {
    INFO(from.name << " about " << at);
    const exact_solution<ball> solution(from.m);
    const auto point = read_expansion_point(at);
    const auto checked = expand_by(recurrence::symmetric_squares, solution, point, order);
    const auto a = taylor_by_thetas(solution, point, order, checked.scale);
    REQUIRE(a.order() == order);
    CHECK(overlaps(a[0], checked.scaled[0]));
    for (int n = 1; n <= order; ++n) {
        INFO("n = " << n);
        CHECK(overlaps(a[n], checked.scaled[n]));
        // One rounding of a_n, which is up to 10 times 8/n at these motions, to the working precision; the loss of the
        // computation with 64 bits more is far smaller.
        CHECK(certainly_less(radius_of(a[n]), epsilon<ball>() * 8 * 8 / n));
    }
}

}  // namespace

TEST_CASE("the quotient of thetas lies on the balls of the recurrence", "[theta_series][ball]") {
    for (const long asked : {30L, 100L, 300L}) {
        const precision_scope scope(asked);
        const int order = asked == 100 ? 240 : 60;
        for (const auto& from : motions()) {
            for (const std::string& at : points) {
                compare_on_balls(from, at, order);
            }
        }
        for (const auto& from : critical_motions()) {
            for (const std::string& at : critical_points) {
                compare_on_balls(from, at, order);
            }
        }
    }
}

using long_scalars = std::tuple<scalar_tag<mpfr>>;

TEMPLATE_LIST_TEST_CASE("without balls it is right to a few ulps", "[theta_series]", long_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& from : motions()) {
        for (const std::string at : {"top", "bottom", "3T/8"}) {
            INFO(from.name << " about " << at);
            const exact_solution<T> solution(from.m);
            const auto point = read_expansion_point(at);
            const T scale = *radius_about(solution, point);
            const auto a = taylor_by_thetas(solution, point, 120, scale);
            const auto sums = lattice_coefficients<T>(from.m, point, scale, 120).between(100, 120);
            for (int n = 100; n <= 120; ++n) {
                INFO("n = " << n);
                // A rounding of the thetas, two of the sums, and an eighth for the omitted poles.
                CHECK_THAT(a[n], near<T>(sums[static_cast<std::size_t>(n - 100)], 4, T(T(8) / n)));
            }
        }
    }
}

TEST_CASE("long expansions at many digits are made of thetas and narrower than by the recurrence",
          "[theta_series][expansion][ball]") {
    const precision_scope scope(500);
    for (const auto& from : {named_motion{"E = 1", with_energy("1")}, {"E = 4, clockwise", with_energy("4", -1)}}) {
        for (const std::string at : {"top", "T/8"}) {
            INFO(from.name << " about " << at);
            const int order = 560;
            const exact_solution<ball> solution(from.m);
            const auto point = read_expansion_point(at);
            const auto view = view_from(from.m, phase_of(point, solution));
            const auto arc = start_and_head(*view, 0, order);
            CHECK(arc.second == head_by::thetas);
            CHECK(arc.first < order);
            const auto found = expand(solution, point, order);
            const auto checked = expand_by(recurrence::symmetric_squares, solution, point, order);
            CHECK(overlaps(found.scaled[0], checked.scaled[0]));
            for (int n = 1; n <= order; ++n) {
                INFO("n = " << n);
                CHECK(overlaps(found.scaled[n], checked.scaled[n]));
                // One rounding of the quotient; two of the sums and an eighth of an epsilon for the omitted poles.
                CHECK(certainly_less(radius_of(found.scaled[n]), epsilon<ball>() * 4 * 8 / n));
                CHECK(is_exact(found.scaled[n]) == !view->powers().has(n));
            }
        }
    }
}

TEST_CASE("long expansions of mpfr at many digits are made of thetas where the program lets FLINT divide",
          "[theta_series][expansion]") {
    const whole_quotient_scope by_whole_sequences(quotient_by_flint);
    const precision_scope scope(300);
    for (const auto& from : {named_motion{"E = 1", with_energy("1")}, {"E = 4, clockwise", with_energy("4", -1)}}) {
        for (const std::string at : {"top", "T/8"}) {
            INFO(from.name << " about " << at);
            const int order = 400;
            const exact_solution<mpfr> solution(from.m);
            const auto point = read_expansion_point(at);
            const auto view = view_from(from.m, phase_of(point, solution));
            CHECK(start_and_head(*view, 0, order).second == head_by::thetas);
            CHECK(start_and_head(*view, 0, order).first < order);
            const auto found = expand(solution, point, order);
            const mpfr ulp = epsilon<mpfr>();
            const precision_scope finer(330);
            const exact_solution<mpfr> fine(from.m);
            const auto checked = taylor_coefficients(start_at(fine, phase_of(point, fine)), order, found.scale);
            for (int n = 1; n <= order; ++n) {
                INFO("n = " << n);
                // One rounding of the quotient; two of the sums and an eighth for the omitted poles.
                CHECK(abs(mpfr(found.scaled[n] - checked[n])) * n <= ulp * 4 * 8);
            }
        }
    }
}

TEST_CASE("few digits and short series keep to the recurrence, and mpfr that is not told",
          "[theta_series][expansion]") {
    const precision_scope scope(50);
    const auto from = [](long bits_of_all) { return (bits_of_all + digits<mpfr>() - 1) / digits<mpfr>(); };
    const long on_balls = from(tuning::thetas_from_bits_on_balls);
    const long in_mpfr = from(tuning::thetas_from_bits_in_mpfr);
    CHECK_FALSE(thetas_cost_less<ball>(true, on_balls - 1));
    CHECK_FALSE(thetas_cost_less<ball>(false, (on_balls - 1) / 2));
    CHECK_FALSE(thetas_cost_less<mpfr>(true, in_mpfr - 1));
    const precision_scope more(3000);
    CHECK_FALSE(thetas_cost_less<ball>(true, tuning::thetas_from_power_on_balls - 1));
    CHECK_FALSE(thetas_cost_less<mpfr>(true, tuning::thetas_from_power_in_mpfr - 1));
    CHECK(thetas_cost_less<ball>(true, tuning::thetas_from_power_on_balls));
    CHECK(thetas_cost_less<ball>(false, tuning::thetas_from_power_on_balls / 2));
    CHECK(thetas_cost_less<mpfr>(true, tuning::thetas_from_power_in_mpfr));
    const exact_solution<mpfr> solution(with_energy("1.71"));
    const auto view = view_from(solution.of(), phase_of({}, solution));
    CHECK(start_and_head(*view, 0, 400).second == head_by::recurrence);
    const whole_quotient_scope by_whole_sequences(quotient_by_flint);
    CHECK(start_and_head(*view, 0, 400).second == head_by::thetas);
}

TEST_CASE("a quotient of thetas has no negative order", "[theta_series]") {
    const precision_scope scope(30);
    const exact_solution<mpfr> solution(with_energy("1.71"));
    CHECK_THROWS_AS(taylor_by_thetas(solution, {}, -1, mpfr(1)), libration::error);
    CHECK(taylor_by_thetas(solution, {}, 0, mpfr(1)).order() == 0);
}

}  // namespace pendulum_theta_series_test
