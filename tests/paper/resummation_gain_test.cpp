// What the resummation gains over the series, and where it loses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/resummation.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_resummation_gain_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

struct comparison {
    explicit comparison(const motion& m) : d(arc_of<mpfr>(m)), solution(m) {}

    jet<mpfr> truth(const mpfr& x) const {
        const auto s = solution.from_top(x);
        return {s.theta, s.omega * d.effective_period()};
    }
    template <class F>
    mpfr norm(const F& f) const {
        const auto exact_jet = [this](const mpfr& x) { return truth(x); };
        return difference_norm<mpfr>(difference(f, exact_jet), chebyshev_points(65)).norm;
    }
    mpfr series_norm(int order) const { return norm(series_from_top(d, order)); }
    mpfr resummed_norm(int order) const { return norm(resummation_from_top(d, order)); }

    fundamental_arc<mpfr> d;
    exact_solution<mpfr> solution;
};

}  // namespace

TEST_CASE("the norm gains about (e^2/4)(K~'/T*)^2 N^2, with the same geometric rate", "[paper]") {
    const precision_scope precision(60);
    for (const std::string energy : {"0.5", "1.71", "1.9998", "2.02", "4"}) {
        const comparison c(with_energy(energy));
        const mpfr ratio = singularity_height(c.d.level()) / c.d.effective_period();
        for (const int order : {40, 80}) {
            // The envelope over neighbouring orders: one error alone may be near a zero of sin(n phi).
            mpfr series(0);
            mpfr resummed(0);
            for (int n = order; n < order + 4; ++n) {
                series = std::max(series, c.series_norm(n));
                resummed = std::max(resummed, c.resummed_norm(n));
            }
            const mpfr predicted = exp(mpfr(2)) / 4 * ratio * ratio * order * order;
            const double measured = (series / resummed / predicted).convert_to<double>();
            INFO("E = " << energy << ", N = " << order << ": " << measured << " of the predicted gain");
            CHECK(measured > 0.5);
            CHECK(measured < 4.9);
        }
    }
}

TEST_CASE("near the top the resummation is worse than a series that has no power N+1", "[paper]") {
    const precision_scope precision(100);
    // alpha t^(N+1) is all error then, and the series errs by t^(N+2): worse by 1/x, times a constant.
    for (const std::string energy : {"0.5", "1.71", "2.02", "10"}) {
        const comparison c(with_energy(energy));
        for (const int even : {4, 10, 20}) {
            const int order = even + (fraction(energy) < 2 ? 0 : 1);
            INFO("E = " << energy << ", N = " << order);
            const auto ratio_at = [&](const mpfr& x) {
                const mpfr theta = c.truth(x).value;
                return mpfr(abs(resummation_from_top(c.d, order)(x).value - theta) /
                            abs(series_from_top(c.d, order)(x).value - theta));
            };
            const mpfr at_tenth = ratio_at(mpfr(1) / 10);
            const mpfr at_hundredth = ratio_at(mpfr(1) / 100);
            CHECK(at_tenth > 1);
            CHECK(at_hundredth > 5 * at_tenth);
        }
    }
}

TEST_CASE("where the series has the power N+1 the resummation may be better even there", "[paper]") {
    const precision_scope precision(60);
    const mpfr x = mpfr(1) / 10;
    for (const std::string energy : {"0.5", "1.71"}) {
        const comparison c(with_energy(energy));
        const mpfr theta = c.truth(x).value;
        CHECK(abs(resummation_from_top(c.d, 5)(x).value - theta) < abs(series_from_top(c.d, 5)(x).value - theta));
    }
}

TEST_CASE("in norm the resummation wins at every N, away from E = 2", "[paper]") {
    const precision_scope precision(60);
    for (const std::string energy : {"1e-6", "0.5", "1", "1.71", "1.9998", "2.0001", "2.02", "4", "100"}) {
        const comparison c(with_energy(energy));
        for (const int order : {0, 1, 2, 5, 10, 20, 40}) {
            INFO("E = " << energy << ", N = " << order);
            CHECK(c.resummed_norm(order) < c.series_norm(order));
        }
    }
}

TEST_CASE("for a fixed N the resummation loses when E is exponentially near 2", "[paper]") {
    const precision_scope precision(150);
    struct losing {
        std::string gap;
        int order;
    };
    for (const auto& [gap, order] :
         std::vector<losing>{{"1e-8", 0}, {"-1e-10", 0}, {"1e-20", 1}, {"-1e-40", 2}, {"1e-100", 5}, {"-1e-100", 10}}) {
        INFO("gap " << gap << ", N = " << order);
        const comparison c(with_gap(gap));
        CHECK(c.resummed_norm(order) > c.series_norm(order));
    }
}

TEST_CASE("the error is not monotone in the energy", "[paper]") {
    const precision_scope precision(60);
    int rises = 0;
    int falls = 0;
    mpfr before(0);
    for (int i = 1; i <= 39; ++i) {
        const mpfr now = comparison(motion::of_energy(rational(i, 20))).series_norm(20);
        rises += now > before ? 1 : 0;
        falls += now < before ? 1 : 0;
        before = now;
    }
    INFO(rises << " times the error grows towards E = 2, " << falls << " times it falls");
    CHECK(rises > 0);
    CHECK(falls > 0);
}

}  // namespace paper_resummation_gain_test
