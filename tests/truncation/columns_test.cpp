// Sums over the columns of singularities, and over single ones, truncated to a few.
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "libration/pendulum/uniform_resummation.hpp"
#include "pendulum/arc/column_sums.hpp"
#include "pendulum/typed.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_columns_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("few pairs of columns hold the motion", "[truncation][separatrix_sum]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const auto& m : {with_energy("0.5"), with_energy("1.71"), with_energy("3", -1)}) {
        const exact_solution<ball> solution(m);
        const auto truth = solution(read_exact("0.4"));
        for (const long pairs : {1, 2, 5}) {
            const auto found = separatrix_sum<ball>(m, pairs)(read_exact("0.4"));
            factors.push_back(times_wider(found.value, truth.theta));
            factors.push_back(times_wider(found.slope, truth.omega));
        }
    }
    // The last pair over cosh d - 1, compared with its sum with alternating signs, 1/(e^d + 1), or equal ones, 1/(e^d -
    // 1): from 2 on, where e^d is large.
    CHECK_THAT(factors, are_factors({2.58, 2.58, 2.598, 2.598, 2.598, 2.598, 2.06, 2.06, 2.06, 2.06, 2.06, 2.06, 2.051,
                                     2.051, 2.052, 2.052, 2.052, 2.052}));
}

TEST_CASE("few terms of the rest of the columns hold its coefficients", "[truncation][column_rest]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const std::string energy : {"1e-3", "4"}) {
        const auto o = energy_level_of<ball>(with_energy(energy));
        const ball y = half_column_distance(o);
        for (const int columns : {1, 2}) {
            const auto truth = column_by_column(o.regime, midpoint_of(y), columns, 8, 160);
            for (const long terms : {1, 2, 5}) {
                const auto found = uniform_remainder(o.regime, y, columns, 8, terms);
                for (int n = o.regime == regime::rotation ? 1 : 2; n <= 8; n += 4) {
                    const ball sum = enclose(ball(truth[static_cast<std::size_t>(n)]), pow(ball(10), -130));
                    factors.push_back(times_wider(found[n], sum));
                }
            }
        }
    }
    // One bound for all powers, of which v^n/n! over cosh v is a part.
    CHECK_THAT(factors,
               are_factors({2.804, 521.2, 2.445, 34.24, 8.589,     4.38, 2.246, 215.9, 1.991, 23.17, 7.068,     3.426,
                            11.83, 2.881, 164.3, 5.183, 9.255e+05, 1246, 11.81, 2.874, 164,   5.172, 9.237e+05, 1244}));
}

TEST_CASE("few powers of the uniform resummation hold the motion", "[truncation][uniform_resummation]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const std::string energy : {"0.5", "4"}) {
        const motion m = with_energy(energy);
        const exact_solution<ball> solution(m);
        const auto top = effective_period(energy_level_of<ball>(m));
        for (const int columns : {1, 2}) {
            for (const int order : {1, 2, 5}) {
                const ball x = ball(columns) / 2;
                const auto found = uniform_from_top<ball>(m, order, columns)(x);
                const auto truth = solution.from_top(x);
                factors.push_back(times_wider(found.value, truth.theta));
                factors.push_back(times_wider(found.slope, ball(truth.omega * top)));
            }
        }
    }
    // Theorem U is the same at every energy, and does not use signs.
    CHECK_THAT(factors,
               are_factors({7.654, 7.516, 2.345, 2.348, 4.058, 4.082, 43.12, 39.09, 4.277, 4.211, 2.075, 2.07,
                            3.596, 3.554, 3.596, 3.554, 2.608, 2.615, 22.35, 20.91, 22.35, 20.91, 1.734, 1.726}));
}

TEST_CASE("few poles hold a coefficient", "[truncation][lattice_coefficients]") {
    const precision_scope scope(many_digits);
    std::vector<double> factors;
    for (const auto& [energy, name] : {std::pair("1.71", "top"), {"0.5", "0.3"}, {"4", "bottom"}}) {
        const motion m = with_energy(energy);
        const exact_solution<ball> solution(m);
        const auto point = read_expansion_point(name);
        const auto truth = expand_by(recurrence::sine_cosine, solution, point, 20);
        const auto view = view_from(m, phase_of(point, solution)).value();
        const auto n = static_cast<int>(view.powers().next(18));
        const auto poles = [&](long bits) { return view.within(pole_reach<ball>(view, bits)(n)).size(); };
        for (const std::size_t wanted : {1U, 2U, 5U}) {
            long bits = -10;
            while (poles(bits) < wanted) {
                ++bits;
            }
            INFO(poles(bits) << " poles within " << bits << " bits");
            CHECK(poles(bits) <= wanted + 2);
            const auto found = lattice_coefficients<ball>(m, point, truth.scale, 20, bits).between(n, n);
            factors.push_back(times_wider(found.front(), truth.scaled[n]));
        }
    }
    // Theorem A1 places all omitted poles where the nearest might be, and S4 includes those that are kept.
    CHECK_THAT(factors,
               are_factors({3.344e+05, 1.421e+04, 3.984e+04, 64.22, 1.83e+05, 2249, 7.52e+06, 8792, 2.778e+04}));
}

TEST_CASE("the sum of the fourth powers of all poles is below its bound", "[truncation][singularity_view]") {
    const precision_scope scope(30);
    std::vector<double> factors;
    for (const std::string energy : {"0.1", "0.5", "1.71", "1.9999", "2.02", "100"}) {
        const motion m = with_energy(energy);
        const exact_solution<ball> solution(m);
        for (const std::string name : {"top", "bottom", "0.3"}) {
            const auto view = view_from(m, phase_of(read_expansion_point(name), solution)).value();
            ball sum(0);
            for (const auto& pole : view.within(ball(view.radius() * 60))) {
                // Both half planes; of two symmetric poles one is listed, with twice the weight.
                sum += ball(2 * std::abs(pole.weight)) / (pole.square * pole.square);
            }
            factors.push_back(midpoint_of(ball(view.fourth_powers() / sum)).convert_to<double>());
        }
    }
    // Least if the nearest column is that of the point, and far from the others.
    CHECK_THAT(factors, are_factors({2.412, 2.402, 2.45, 2.282, 1.993, 2.339, 3.19, 1.507, 3.318, 9.396, 1.26, 9.811,
                                     5.188, 1.34, 5.451, 2.58, 2.612, 2.62}));
}

}  // namespace truncation_columns_test
