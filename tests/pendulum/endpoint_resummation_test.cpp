// Resummations with m derivatives at the bottom: their data, their bound and their rates.
#include "libration/pendulum/endpoint_resummation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_endpoint_resummation_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the derivatives at the bottom are those of the expansion about it", "[endpoint_resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "2.02", "4"}) {
        INFO("E = " << energy);
        const motion m = with_energy(energy);
        const fundamental_arc<T> arc = arc_of<T>(m);
        const auto endpoint = arc_endpoint(arc, 12);
        // About the bottom by the exact solution, and the recurrence without symmetry.
        const auto expected =
            expand_by(recurrence::sine_cosine, exact_solution<T>(m), read_expansion_point("bottom"), 11);
        const auto in_periods = rescale(expected.scaled, T(arc.effective_period() / expected.scale));
        REQUIRE(endpoint.size() == 12);
        for (int j = 0; j < 12; ++j) {
            using std::pow;
            const T size =
                pow(T(arc.effective_period() / expected.scale), j) + 1;  // |coefficients| K~'^j are below 4/j
            CHECK_THAT(endpoint[static_cast<std::size_t>(j)], near<T>(in_periods[j], 60, size));
        }
        CHECK(arc_endpoint(arc, 0).empty());
        CHECK_THROWS_AS(arc_endpoint(arc, -1), libration::error);
    }
}

TEMPLATE_LIST_TEST_CASE("two conditions make the paper's resummation, and its bound", "[endpoint_resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "2.02"}) {
        const fundamental_arc<T> arc = arc_of<T>(with_energy(energy));
        const auto two = endpoint_from_top(arc, 9, 2);
        const auto papers = resummation_from_top(arc, 9);
        CHECK_THAT(two(T(1) / 3).value, near<T>(papers(T(1) / 3).value, 4));
        const auto bounds = top_bounds<T>::of(arc.level());
        CHECK_THAT(endpoint_norm(bounds, 9, 2), near<T>(bounds.resummation_norm(9), 40));
        CHECK_THROWS_AS(endpoint_norm(bounds, 0, 0), libration::error);  // theorem A begins with n = 4
        CHECK(two_point_from_top(arc, 4).order() == 4);
    }
}

TEST_CASE("the bound for m conditions is above the error, m = 0 to N + 1", "[endpoint_resummation]") {
    const precision_scope precision(90);
    for (const std::string energy : {"0.1", "0.5", "1.3", "1.71", "1.999", "1.99999999", "2.001", "2.5", "100"}) {
        arc_errors errors(with_energy(energy));
        for (const int order : {3, 8, 21}) {
            for (const int conditions : {0, 1, 2, 4, 8, order + 1}) {
                INFO("E = " << energy << ", N = " << order << ", m = " << conditions);
                const auto f = endpoint_from_top(errors.arc(), order, conditions);
                CHECK(errors.norm_of(f, order + conditions).norm <= endpoint_norm(errors.bounds(), order, conditions));
            }
        }
    }
}

TEST_CASE("the two-point expansion falls or grows at its rate", "[endpoint_resummation]") {
    // The envelope of eight neighbours, for the phase of the singularities, around the middle, where the error is
    // largest.
    const auto largest = [](const exact_solution<mpfr>& truth, const fundamental_arc<mpfr>& arc, int order) {
        mpfr all(0);
        for (int n = order; n < order + 8; ++n) {
            const auto f = two_point_from_top(arc, n);
            for (int i = 4; i <= 8; ++i) {
                const mpfr x = mpfr(i) / 12;
                all = std::max(all, mpfr(abs(f(x).value - truth.from_top(x).theta)));
            }
        }
        return all;
    };
    for (const std::string gap : {"1.5", "0.29", "1e-3", "1e-6"}) {
        INFO("gap " << gap);
        const precision_scope precision(160);
        const exact_solution<mpfr> truth(with_gap(gap));
        const auto arc = arc_of<mpfr>(with_gap(gap));
        const mpfr rate = two_point_rate(top_bounds<mpfr>::of(arc.level()));
        CHECK((rate > 1) == (gap == "1e-6"));
        const mpfr measured = pow(mpfr(largest(truth, arc, 110) / largest(truth, arc, 30)), mpfr(mpfr(1) / 80));
        CHECK(abs(measured / rate - 1) < mpfr("0.04"));  // powers of N: (110/30)^(-3/2) over 80 steps is 0.976
    }
    const precision_scope precision(30);
    const auto rate_at = [](const std::string& gap) {
        return two_point_rate(top_bounds<mpfr>::of(energy_level_of<mpfr>(with_gap(gap))));
    };
    CHECK(rate_at("7.75e-5") < 1);
    CHECK(rate_at("7.74e-5") > 1);
    CHECK(rate_at("-7.75e-5") < 1);
    CHECK(rate_at("-7.74e-5") > 1);
}

}  // namespace pendulum_endpoint_resummation_test
