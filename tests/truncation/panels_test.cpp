// Polynomials of too low an order for the proved norms, and a search that ends too soon.
#include <utility>
#include <vector>

#include "libration/approximant/pade_error.hpp"
#include "libration/pendulum/proved_norm.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_panels_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;
using series::power_series;

TEST_CASE("a panel of low order holds the function and two derivatives", "[truncation][panel]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    const ball q = ball(1) / 5;
    for (const int order : {1, 2, 5}) {
        // 3/(1 - q s) = sum 3 q^n s^n, and its derivatives, at 1, where nothing in the tails cancels, and at -2/3.
        power_series<ball> kept(std::vector<ball>{ball(3)});
        for (int n = 1; n <= order; ++n) {
            kept.push_back(pow(q, n) * 3);
        }
        const enclosed_panel panel(kept, ball(3), q, -1, 1);
        for (const ball& s : {ball(1), ball(ball(-2) / 3)}) {
            const auto found = panel.at(s);
            const ball f = 1 / (1 - q * s);
            factors.push_back(times_wider(found.value, ball(f * 3)));
            factors.push_back(times_wider(found.slope, ball(f * f * q * 3)));
            factors.push_back(times_wider(found.curvature, ball(f * f * f * q * q * 6)));
        }
    }
    // At 1 the tail of the value is the geometric series itself, that of the slope n/(1-q) compared with n + q/(1-q).
    CHECK_THAT(factors, are_factors({1, 1.111, 1, 3.188, 2.822, 2.843, 1, 1.154, 1.23, 4.781, 4.147, 3.743, 1, 1.2,
                                     1.415, 16.14, 13.72, 11.75}));
}

TEST_CASE("few steps of Newton's iteration hold the maximum and its place", "[truncation][proved_maximum]") {
    const precision_scope scope(4 * many_digits);
    // s - s^3 + s^4/10 is largest where 1 - 3 s^2 + 2 s^3/5 = 0.
    const power_series<ball> f(std::vector<ball>{ball(0), ball(1), ball(0), ball(-1), ball(1) / 10});
    ball s = ball(3) / 5;
    for (int i = 0; i < 15; ++i) {
        s = midpoint(ball(s - (1 - s * s * 3 + s * s * s * 2 / 5) / (s * s * 6 / 5 - s * 6)));
    }
    const ball place = enclose(s, pow(ball(10), 4 - 4 * many_digits));
    const ball value = place - pow(place, 3) + pow(place, 4) / 10;
    std::vector<double> factors;
    for (const int steps : {0, 1, 2, 5}) {
        const auto found = largest_magnitude({enclosed_panel(f, ball(0), ball(1) / 4, 0, 1)}, steps);
        factors.push_back(times_wider(found.value, value));
        factors.push_back(times_wider(found.place, ball((1 + place) / 2)));
    }
    // The difference from the extreme value is f'^2/(2 mu) with mu near |f''|.
    CHECK_THAT(factors, are_factors({1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST_CASE("panels of low order hold an error norm", "[truncation][proved_norm]") {
    // For polynomials with more powers than the panels, which use the tail of theta for the missing ones.
    const precision_scope scope(40);
    const rational energy(1, 2);
    arc_errors sampled(motion::of_energy(energy));
    std::vector<double> factors;
    for (const auto& [order, degree] : {std::pair(16, 20), {24, 30}, {32, 36}}) {
        const auto found = proved_arc_errors(libration::exactly(energy), order).norm(arc_method::resummed, degree);
        const auto truth = sampled.norm(arc_method::resummed, degree);
        factors.push_back(times_wider(found.value, ball(truth.norm)));
    }
    // theta's coefficients have signs, which theorem A1 does not use.
    CHECK_THAT(factors, are_factors({9.317, 2.767, 14.36}));
    CHECK_THROWS_AS(proved_arc_errors(libration::exactly(1), 2), libration::error);
}

}  // namespace truncation_panels_test
