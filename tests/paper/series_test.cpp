// The claims of section III A, judged once more.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "libration/series/exponential.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"

namespace paper_series_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

expansion<mpfr> about(const std::string& energy, const std::string& point, int order) {
    return expand(exact_solution<mpfr>(with_energy(energy)), read_expansion_point(point), order);
}

}  // namespace

// a_2 = -sin(1)/2, a_3 = -cos(1)/12 for omega0 = 1/2, by hand.
TEST_CASE("claim pendulum_recurrence: holds, the sums solve the equation", "[paper][claims]") {
    check_identity("pendulum_recurrence");
    const precision_scope precision(50);
    const auto e = expand(exact_solution<mpfr>(with_state("1", "1/2")), read_expansion_point("start"), 3);
    CHECK(abs(e.scaled[2] / (e.scale * e.scale) + sin(mpfr(1)) / 2) < mpfr("1e-47"));
    CHECK(abs(e.scaled[3] / (e.scale * e.scale * e.scale) + cos(mpfr(1)) / 12) < mpfr("1e-47"));
}

// exp(x + x^2) = 1 + x + 3/2 x^2 + 7/6 x^3 + 25/24 x^4.
TEST_CASE("claim exponential_recurrence: holds", "[paper][claims]") {
    check_identity("exponential_recurrence");
    const precision_scope precision(50);
    const auto b = exponential(power_series<mpfr>({mpfr(0), mpfr(1), mpfr(1), mpfr(0), mpfr(0)}));
    CHECK(abs(b[3] - mpfr(7) / 6) < mpfr("1e-48"));
    CHECK(abs(b[4] - mpfr(25) / 24) < mpfr("1e-48"));
}

TEST_CASE("claim series_labels: corrected, the two labels are exchanged", "[paper][claims]") {
    check_claim("series_labels", verdict::corrected, "0.3", "0.5");
    const precision_scope precision(50);
    // theta = t: the recurrence that carries the label of the cosine gives 1 first.
    const auto [s, c] = sine_cosine(power_series<mpfr>({mpfr(0), mpfr(1)}));
    CHECK(s[1] == 1);
    CHECK(c[1] == 0);
}

TEST_CASE("claim four_equations_agree: holds", "[paper][claims]") { check_identity("four_equations_agree"); }

TEST_CASE("claim arcsine_route: holds", "[paper][claims]") { check_identity("arcsine_route"); }

// -2 k k' sd is omega of libration from the top: sd' = cn nd^2, so a_2 = -k k' = -sin(theta0)/2.
TEST_CASE("claim arcsine_is_required: corrected, omega is a Jacobi function and integrates term by term",
          "[paper][claims]") {
    check_claim("arcsine_is_required", verdict::corrected, "0", "1e-40");
    const precision_scope precision(50);
    const auto shape = energy_level_of<mpfr>(with_energy("1.71")).modulus;
    for (const int time : {1, 3}) {
        const auto v = jacobi(mpfr(time), shape);
        const mpfr omega = state_of<mpfr>(with_energy("1.71"), std::to_string(time)).omega;
        CHECK(abs(omega + shape.k * shape.complement * v.sn / v.dn * 2) < mpfr("1e-47"));
    }
}

// Products up to a_100: 2 * 98*99/2 against 98*99/2 and sum_{n<98} (n//2 + 1) = 2450.
TEST_CASE("claim elliptic_route_costs_more: corrected, omega takes three quarters of the products", "[paper][claims]") {
    check_number("elliptic_route_costs_more", verdict::corrected, "0.75252525252525253");  // (2450 + 4851)/9702
}

TEST_CASE("claim runge_kutta_is_the_truth: holds, its error is far below that of double", "[paper][claims]") {
    check_claim("runge_kutta_is_the_truth", verdict::holds, "1e-22", "1e-21");
    // In double the rounding of 1000 steps is all there is.
    runge_kutta_march<double> march({1.0, 0.0}, 1e-5);
    const double theta = march.advance_to(0.01).value;
    CHECK(std::abs(theta - state_of<double>(with_state("1", "0"), "0.01").theta) < 1e-14);
}

// q = ellipk(mpf('0.145'))/ellipk(mpf('0.855')); 4/mpf(999)*q**-999: one pair +-i K' at the bottom.
TEST_CASE("claim figure_series_diverges: holds, the terms at T* grow", "[paper][claims]") {
    check_claim("figure_series_diverges", verdict::holds, "3.39e165", "3.40e165");
    const precision_scope precision(50);
    for (const std::string energy : {"1.71", "2.02"}) {
        CHECK(about(energy, "bottom", 1).scale < effective_period(energy_level_of<mpfr>(with_energy(energy))));
    }
}

TEST_CASE("claim figure_series_orders: corrected, there are no even powers at the bottom", "[paper][claims]") {
    check_claim("figure_series_orders", verdict::corrected, "0", "0");
    const precision_scope precision(50);
    const auto e = about("1.71", "bottom", 101);
    CHECK(e.scaled[10] == 0);
    CHECK(e.scaled[100] == 0);
    CHECK(e.scaled[99] != 0);
}

}  // namespace paper_series_test
