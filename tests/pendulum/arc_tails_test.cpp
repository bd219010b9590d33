#include "libration/pendulum/arc_tails.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_descent_tails_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("errors from the omitted terms are those of the approximations in many digits", "[descent_tails]") {
    const precision_scope precision(80);
    const std::vector<double> points{0.125, 0.5, 0.75, 0.96875, 1};
    for (const std::string energy : {"1.71", "2.02"}) {
        const auto arc = arc_of<mpfr>(with_energy(energy));
        const int highest = 800;  // omits (T*/R)^760, below 1e-25 of the error
        std::vector<long double> a;
        const auto series = arc_series(arc, highest);
        a.reserve(series.coefficients().size());
        for (const mpfr& each : series.coefficients()) {
            a.push_back(narrow<long double>(each));
        }
        arc_tails<long double> tails(a, points);
        std::vector<long double> errors(points.size());
        const exact_solution<mpfr> truth(with_energy(energy));
        for (const int order : {799, 500, 40}) {
            tails.step_down_to(order);
        }
        CHECK(tails.order() == 40);
        for (const auto method : {arc_method::series, arc_method::resummed}) {
            tails.errors(method, errors);
            for (std::size_t i = 0; i < points.size(); ++i) {
                INFO("E = " << energy << ", x = " << points[i]);
                const mpfr x(points[i]);
                const mpfr value = method == arc_method::series ? series_from_top(arc, 40)(x).value
                                                                : resummation_from_top(arc, 40)(x).value;
                const mpfr expected = abs(value - truth.from_top(x).theta);
                if (points[i] == 1 && method == arc_method::resummed) {
                    CHECK(errors[i] == 0);
                    continue;
                }
                // 760 steps of half an epsilon, and the resummed error at 31/32 cancels (1-x)^2 N^2: 3 digits are
                // permitted.
                CHECK(abs(widen(errors[i]) / expected - 1) < widen(epsilon<long double>()) * 380'000);
            }
        }
    }
}

TEST_CASE("errors grow from one order to the next by no more than is said", "[descent_tails]") {
    // exp(x/2) without what is below 2^-40/40!, at the points k/32.
    std::vector<double> a{1};
    for (int n = 1; n <= 40; ++n) {
        a.push_back(a.back() / (2 * n));
    }
    std::vector<double> points;
    for (int k = 1; k <= 32; ++k) {
        points.push_back(k / 32.0);
    }
    for (const auto method : {arc_method::series, arc_method::resummed}) {
        arc_tails<double> tails(a, points);
        tails.step_down_to(20);
        std::vector<double> above(points.size());
        std::vector<double> now(points.size());
        std::vector<double> left_out(points.size());
        tails.errors(method, above);
        for (int order = 19; order >= 0; --order) {
            tails.step_down_to(order);
            tails.errors(method, now);
            double most = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                most = std::max(most, now[i] - above[i]);
            }
            INFO("N = " << order);
            // All terms have one sign: at x = 1 and near (N+1)/(N+3) it is all of it, but for the grid. The
            // terms left out, which both errors are made of, are rounded in 20 steps of Horner's rule, twice each.
            const double said = tails.growth(method, order);
            tails.errors(arc_method::series, left_out);
            const double rounding = 40 * epsilon<double>() * *std::ranges::max_element(left_out);
            CHECK(most <= said + rounding);
            CHECK(most >= said * (method == arc_method::series ? 1 : 0.97) - rounding);
            std::swap(now, above);
        }
    }
}

TEST_CASE("points outside of the way down are refused", "[descent_tails]") {
    CHECK_THROWS_AS(arc_tails<double>({1, 2}, {0}), libration::error);
    CHECK_THROWS_AS(arc_tails<double>({1, 2}, {1.5}), libration::error);
}

}  // namespace pendulum_descent_tails_test
