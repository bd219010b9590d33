// (omegab), (resummation) and (efficient) as printed and as they must be: omega* = -sqrt(2E) for a bob that falls, and
// + theta* for a rotation, which arrives at 2 pi.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/pendulum/resummation.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_resummation_sign_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// The norm on [0, T*] of theta less the resummation that ends in (theta*, omega* T*).
mpfr norm_with(const std::string& energy, int order, const std::vector<mpfr>& endpoint) {
    const motion m = with_energy(energy);
    const auto d = arc_of<mpfr>(m);
    const exact_solution<mpfr> solution(m);
    const endpoint_approximant<mpfr> resummed(arc_series(d, order), endpoint);
    const auto truth = [&](const mpfr& x) {
        const auto s = solution.from_top(x);
        return jet<mpfr>{s.theta, s.omega * d.effective_period()};
    };
    return difference_norm<mpfr>(difference(resummed, truth), chebyshev_points(101)).norm;
}

}  // namespace

TEST_CASE("with the sign of (omegab) as printed the error of libration is 2 sqrt(2E) T*/(e N)", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"0.5", "1.71"}) {
        const auto d = arc_of<mpfr>(with_energy(energy));
        const mpfr speed = sqrt(d.level().pair.energy * 2) * d.effective_period();
        for (const int order : {100, 200, 400}) {
            INFO("E = " << energy << ", N = " << order);
            const mpfr printed = norm_with(energy, order, {mpfr(0), speed});
            const mpfr predicted = speed * 2 / (exp(mpfr(1)) * order);
            CHECK(abs(printed / predicted - 1) < mpfr(3) / order);  // the next term is 3/(2N)
            CHECK(norm_with(energy, order, {mpfr(0), mpfr(-speed)}) < predicted / 100000);
        }
    }
}

TEST_CASE("without theta* the resummation of a rotation ends 2 pi away", "[paper]") {
    const precision_scope precision(40);
    const auto d = arc_of<mpfr>(with_energy("2.02"));
    const mpfr slope = d.bottom().slope * d.effective_period();
    const mpfr printed = norm_with("2.02", 40, {mpfr(0), slope});
    CHECK_THAT(printed, near<mpfr>(mpfr(pi<mpfr>() * 2), 4));
    CHECK(norm_with("2.02", 40, {mpfr(pi<mpfr>() * 2), slope}) < mpfr(1) / 100);
}

TEST_CASE("the printed alpha and beta are those of theta* = 0", "[paper]") {
    const precision_scope precision(40);
    for (const std::string energy : {"1.71", "2.02"}) {
        INFO(energy);
        const int order = 12;
        const auto d = arc_of<mpfr>(with_energy(energy));
        const mpfr period = d.effective_period();
        auto polynomial = rescale(arc_series(d, order), mpfr(1 / period));
        const jet<mpfr> sigma = evaluate(polynomial, period);
        const mpfr slope_off = d.bottom().slope - sigma.slope;
        // (efficient) as printed.
        polynomial.push_back(-sigma.value * (order + 2) * pow(period, -order - 1) - slope_off * pow(period, -order));
        polynomial.push_back(sigma.value * (order + 1) * pow(period, -order - 2) + slope_off * pow(period, -order - 1));
        const jet<mpfr> end = evaluate(polynomial, period);
        CHECK(abs(end.value) < mpfr("1e-35"));  // 0, whatever theta* is
        CHECK(abs(end.slope - d.bottom().slope) < mpfr("1e-35"));
        CHECK((d.bottom().value == 0) == (fraction(energy) < 2));
    }
}

TEST_CASE("T*^(-N-1) and a_n leave the range of double before N = 1000, the scaled resummation does not", "[paper]") {
    const auto d = arc_of<double>(with_energy("1.9998"));
    CHECK(std::pow(d.effective_period(), 1001) == HUGE_VAL);
    const auto resummed = resummation_from_top(d, 1000);
    const exact_solution<double> solution(with_energy("1.9998"));
    for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        INFO(x);
        // The truncation error is 1e-11 here (rho = 0.967); rounding is smaller.
        CHECK(std::abs(resummed(x).value - solution.from_top(x).theta) < 1e-10);
    }
}

}  // namespace paper_resummation_sign_test
