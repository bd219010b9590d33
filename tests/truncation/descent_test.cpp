// The arithmetic-geometric mean, Jacobi's functions and the incomplete integral by Landen chains with too few levels.
#include <vector>

#include "libration/elliptic/incomplete_integral.hpp"
#include "truncation/arb_theta.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_descent_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

// k' = 1/2.
modulus<ball> half_complement() { return modulus<ball>::from_complement(ball(1) / 2); }

}  // namespace

TEST_CASE("a chain of few levels holds the mean", "[truncation][landen]") {
    const precision_scope scope(many_digits);
    const ball truth = arb_mean(ball(1) / 2);
    std::vector<double> factors;
    for (const int levels : {0, 1, 2, 5}) {
        factors.push_back(times_wider(landen_chain<ball>(half_complement(), levels).mean(), truth));
    }
    // agm(1+x, 1-x) = 1 - x^2/4 - 5 x^4/64 - .. [DLMF 19.8.2] with x = k_{N+1}, and the bound is x.
    CHECK_THAT(factors, are_factors({11.57, 135.8, 1.846e+04, 1.346e+34}));
}

TEST_CASE("a chain of few levels holds Jacobi's functions", "[truncation][jacobi]") {
    const precision_scope scope(many_digits);
    const modulus<ball> m = half_complement();
    const arb_jacobi truth(m.k, m.complement);
    std::vector<double> factors;
    const ball u = ball(2) / 5;
    const auto at = truth(u);
    for (const int levels : {0, 1, 2, 5}) {
        const auto found = jacobi_at(u, landen_chain<ball>(m, levels));
        factors.push_back(times_wider(found.sn, at.sn));
        factors.push_back(times_wider(found.cn, at.cn));
        factors.push_back(times_wider(found.dn, at.dn));
    }
    // am(v, k) is v - k^2/4 (v - sin v cos v) and dn is 1 - k^2/2 sin^2 v to first order, compared with k^2 v and k^2;
    // in the ascent the radii add while the errors cancel.
    CHECK_THAT(factors, are_factors({7.241, 4.82, 13.3, 25.74, 44.69, 47.42, 109.8, 78.89, 237.1, 104.9, 78.18, 254}));
    // Beyond K the signs would be wrong: throws, for the chain with few levels as well.
    CHECK_THROWS_AS(jacobi_at(ball(truth.period() * 101 / 100), landen_chain<ball>(m)), precision_exhausted);
    CHECK_THROWS_AS(jacobi_at(ball(truth.period() * 101 / 100), landen_chain<ball>(m, 1)), precision_exhausted);
}

TEST_CASE("a chain of few levels holds the incomplete integral", "[truncation][incomplete_integral]") {
    const precision_scope scope(many_digits);
    const modulus<ball> m = half_complement();
    std::vector<double> factors;
    const ball phi = ball(1);
    const ball truth = arb_incomplete(phi, ball(3) / 4);
    for (const int levels : {0, 1, 2, 5}) {
        const landen_chain<ball> chain(m, levels);
        factors.push_back(times_wider(incomplete_integral(ball(sin(phi)), ball(cos(phi)), chain), truth));
    }
    // The integrand is between 1 and 1/k_N', in the mean about halfway.
    CHECK_THAT(factors, are_factors({7.019, 1.935, 2.117, 2.006}));
}

}  // namespace truncation_descent_test
