// The bounds A and A2 of the truncation errors of a series and its resummation, compared with the sums over the bounds
// of the coefficients from which they are derived.
#include <string>
#include <vector>

#include "libration/pendulum/bounds.hpp"
#include "pendulum/typed.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_bounds_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

double quotient(const ball& a, const ball& b) { return midpoint_of(ball(a / b)).convert_to<double>(); }

}  // namespace

TEST_CASE("the bounds of the norms are the sums over those of the coefficients", "[truncation][bounds]") {
    const precision_scope scope(40);
    std::vector<double> of_series;
    std::vector<double> of_resummation;
    for (const std::string energy : {"0.5", "1.71", "4"}) {
        const auto bounds = top_bounds<ball>::of(energy_level_of<ball>(with_energy(energy)));
        for (const int order : {3, 6, 15}) {
            ball series(0);
            for (int n = bounds.first_omitted(order); n < 600; n += 2) {
                series += bounds.coefficient(n) * pow(bounds.rho, n);
            }
            of_series.push_back(quotient(bounds.series_norm(order), series));
            // Of x^(N+1+j) the error is at most u^(N+1) (1-u)^2 j(j-1)/2, which is largest at u = (N+1)/(N+3).
            const ball u = ball(order + 1) / (order + 3);
            const ball shape = pow(u, order + 1) * (1 - u) * (1 - u);
            ball resummation(0);
            for (int j = 2; j < 600; ++j) {
                const int n = order + 1 + j;
                resummation += bounds.coefficient(n) * pow(bounds.rho, n) * shape * (j * (j - 1) / 2);
            }
            of_resummation.push_back(quotient(bounds.resummation_norm(order), resummation));
        }
    }
    // 1/n of the first term is used for all others: the factor grows with the number of relevant powers.
    // A factor below 1 would disprove the bound.
    CHECK_THAT(of_series, are_factors({1.187, 1.114, 1.065, 1.583, 1.36, 1.21, 1.253, 1.199, 1.098}));
    CHECK_THAT(of_resummation, are_factors({1.64, 1.449, 1.24, 2.807, 2.261, 1.677, 1.945, 1.662, 1.355}));
}

}  // namespace truncation_bounds_test
