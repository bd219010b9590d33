#include "libration/pendulum/least_order.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_least_order_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("the proved order is the first whose bound is small enough", "[least_order]") {
    const precision_scope precision(40);
    for (const std::string energy : {"0.01", "1.71", "2.02", "8"}) {
        const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(with_energy(energy)));
        for (const int digits : {6, 30}) {
            INFO("E = " << energy << ", D = " << digits);
            const mpfr goal = pow(mpfr(10), -digits);
            const int of_series = proved_order(bounds, arc_method::series, digits);
            CHECK(bounds.series_norm(of_series) <= goal);
            CHECK((of_series == 4 || bounds.series_norm(of_series - 1) > goal));
            const int resummed = proved_order(bounds, arc_method::resummed, digits);
            CHECK(bounds.resummation_norm(resummed) <= goal);
            CHECK((resummed == 4 || bounds.resummation_norm(resummed - 1) > goal));
        }
    }
}

TEST_CASE("the error from running sums is that of the approximations", "[least_order]") {
    const precision_scope precision(70);
    for (const std::string energy : {"1.71", "2.02"}) {
        const motion m = with_energy(energy);
        const arc_orders orders(m, 10);
        const auto arc = arc_of<mpfr>(m);
        const exact_solution<mpfr> truth(m);
        for (const int order : {0, 1, 2, 17, 40}) {
            INFO("E = " << energy << ", N = " << order);
            const mpfr x = mpfr(11) / 16;
            const auto state = truth.from_top(x);
            const auto plain = series_from_top(arc, order)(x);
            const auto resummed = resummation_from_top(arc, order)(x);
            const auto error_of_plain = orders.error_at(arc_method::series, order, x);
            const auto error_of_resummed = orders.error_at(arc_method::resummed, order, x);
            // 70 digits, theta and its slope below 10, and some digits for 40 powers.
            CHECK(abs(plain.value - state.theta - error_of_plain.value) < mpfr("1e-64"));
            CHECK(abs(plain.slope - state.omega * arc.effective_period() - error_of_plain.slope) < mpfr("1e-64"));
            CHECK(abs(resummed.value - state.theta - error_of_resummed.value) < mpfr("1e-64"));
            CHECK(abs(resummed.slope - state.omega * arc.effective_period() - error_of_resummed.slope) < mpfr("1e-64"));
        }
    }
}

TEST_CASE("more digits than long double holds are refused", "[least_order]") {
    CHECK_THROWS_AS(arc_orders(with_energy("1"), 4001), libration::error);
    CHECK_THROWS_AS(arc_orders(with_energy("2"), 10), libration::error);
}

}  // namespace pendulum_least_order_test
