#include "libration/pendulum/other_recurrences.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_other_recurrences_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
struct starting_point {
    taylor_start<T> start;
    T radius;
};

template <class T>
starting_point<T> point_of(const motion& m, const std::string& at) {
    const exact_solution<T> solution(m);
    const auto phase = phase_of(read_expansion_point(at), solution);
    return {start_at(solution, phase), singularities<T>(m)->radius(phase)};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("omega alone makes the coefficients of theta", "[pendulum][other_recurrences]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "2.02", "8"}) {
        for (const std::string at : {"top", "bottom", "0.3"}) {
            const auto from = point_of<T>(with_energy(energy), at);
            const auto expected = taylor_by_symmetric_squares(from.start, 40, from.radius);
            const auto found = taylor_by_speed(from.start, 40, from.radius);
            INFO("E = " << energy << " about " << at);
            for (int n = 0; n <= 40; ++n) {
                // 40 steps of sums of 40 terms below 8 each; both recurrences round.
                CHECK_THAT(found[n], near(expected[n], 4000, T(4)));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the arcsine of the Jacobi function makes the coefficients of theta where it is stable",
                        "[pendulum][other_recurrences]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [energy, at] :
         {std::pair{"0.5", "top"}, std::pair{"0.5", "0.3"}, std::pair{"2.02", "bottom"}, std::pair{"8", "bottom"}}) {
        auto from = point_of<T>(with_energy(energy), at);
        if (from.start.of_theta == parity::odd) {
            from.start.state.theta = T(0);  // the parity is that of theta - theta_0, y needs theta_0 = 0
            from.start.state.half_sine = T(0);
            from.start.state.half_cosine = T(1);
        }
        const auto expected = taylor_by_sine_cosine(from.start, 20, from.radius);
        const auto found = taylor_by_arcsine(from.start, 20, from.radius);
        INFO("E = " << energy << " about " << at);
        for (int n = 0; n <= 20; ++n) {
            // (R/K~')^20 is below 200 at E = 0.5 from the top and 1 from the bottom.
            CHECK_THAT(found[n], near(expected[n], 20'000, T(4)));
        }
    }
}

TEST_CASE("rounding in the arcsine's quotient grows by R/K~' a power", "[pendulum][other_recurrences]") {
    const auto error = [](const std::string& energy, int order) {
        const precision_scope scope(200);
        const auto exact = point_of<mpfr>(with_energy(energy), "top");
        const auto expected = taylor_by_symmetric_squares(exact.start, order, exact.radius);
        const precision_scope narrow_scope(30);
        const auto from = point_of<mpfr>(with_energy(energy), "top");
        const auto found = taylor_by_arcsine(from.start, order, from.radius);
        mpfr largest(0);
        for (int n = order - 9; n <= order; ++n) {
            largest = std::max(largest, mpfr(abs(found[n] - expected[n])));
        }
        return largest;
    };
    for (const std::string energy : {"1", "1.71", "1.99"}) {
        const precision_scope scope(40);
        const auto lattice = *singularities<mpfr>(with_energy(energy));
        const mpfr ratio = lattice.effective_period / lattice.height;
        const mpfr growth = log10(1 + ratio * ratio) / 2 * 100;  // of (R/K~')^100
        const mpfr measured = log10(error(energy, 160) / error(energy, 60));
        INFO("E = " << energy);
        CHECK(abs(measured - growth) < 1);  // the same to the oscillation of ten errors
    }
}

TEST_CASE("at the top of rotation the arcsine has its branch point", "[pendulum][other_recurrences]") {
    const auto from = point_of<double>(with_energy("2.02"), "top");
    CHECK_THROWS_AS(taylor_by_arcsine(from.start, 10, from.radius), libration::error);
    CHECK_THROWS_AS(taylor_by_arcsine(from.start, -1, from.radius), libration::error);
    CHECK_THROWS_AS(taylor_by_speed(from.start, -1, from.radius), libration::error);
}

}  // namespace pendulum_other_recurrences_test
