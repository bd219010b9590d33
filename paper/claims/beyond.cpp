// Beyond the paper: the claims of this program, measured like the statements of the paper.
#include <algorithm>
#include <string_view>

#include "claim.hpp"
#include "judging.hpp"
#include "libration/pendulum/arc_approximations.hpp"

namespace libration {

using namespace series;
using namespace pendulum;

using namespace judging;

namespace {

// Energies of all sizes: towards rest, towards E = 2 from both sides, and fast.
std::vector<motion> all_energies() {
    std::vector<motion> all;
    for (const std::string_view energy : {"1e-20", "1e-6", "0.1", "1", "1.71", "2.02", "4", "1e4"}) {
        all.push_back(of_energy(energy));
    }
    for (const std::string_view gap : {"1e-3", "1e-10", "1e-100"}) {
        all.push_back(of_gap(gap));
        all.push_back(motion::of_energy(rational(2 + fraction(gap))));
    }
    return all;
}

// The error norm of the uniform resummation to the power N, with sufficiently many digits.
mpfr uniform_norm(const motion& m, int order) {
    const precision_scope enough(uniform_digits_below(m, order) + 20);
    return arc_errors(m).norm_of(uniform_from_top<mpfr>(m, order), order).norm;
}

claim uniform_rate_below_third() {
    return {.name = "uniform_rate_below_third",
            .label = "libration: uniform resummation",
            .statement =
                "With its two nearest columns of singularities in closed form theta has a series from the top whose "
                "error on [0, T*], cut after the power N, is below (1/3)^N at every energy.",
            .number = "largest (norm)^(1/N), N = 4, 12, 24, 48, at energies from 1e-20 to 1e4",
            .correction = "",
            .command = "./run study uniform --energies 1e-20,1.71,4 --gaps 1e-10,-1e-10 --orders 8,16,32",
            .measure = [] {
                mpfr worst(0);
                for (const motion& m : all_energies()) {
                    for (const int order : {4, 12, 24, 48}) {
                        worst = std::max(worst, mpfr(pow(uniform_norm(m, order), mpfr(mpfr(1) / order))));
                    }
                }
                return by_test(worst < mpfr(1) / 3, worst);
            }};
}

claim sixteen_coefficients() {
    return {
        .name = "sixteen_coefficients",
        .label = "libration: uniform resummation",
        .statement =
            "Sixteen coefficients that are not 0 give theta to double precision, 1.4e-16, at every energy from 1e-20 "
            "to 2 - 1e-100, 2 + 1e-100 and 1e4.",
        .number = "largest error norm with the powers to 32 (libration) or 31 (rotation)",
        .correction = "",
        .command = "./run trajectory --gap 1e-12 --method uniform --order 32 --times 0:14:15",
        .measure = [] {
            mpfr worst(0);
            for (const motion& m : all_energies()) {
                worst = std::max(worst, uniform_norm(m, 32 - parity_from_top(m.regime())));
            }
            return by_test(worst < number("1.4e-16"), worst);
        }};
}

claim uniform_bound() {
    return {.name = "uniform_bound",
            .label = "libration: theorem U",
            .statement = "The error of the uniform resummation is below the bound of theorem U.",
            .number = "smallest bound over error norm, N = 4, 15, 16, 33, at energies from 1e-20 to 1e4",
            .correction = "",
            .command = "./run study uniform --energies 1e-20,1.71,4 --gaps 1e-10,-1e-10 --orders 2,8,16",
            .measure = [] {
                mpfr smallest(1000);
                for (const motion& m : all_energies()) {
                    const uniform_bounds<mpfr> bounds{parity_from_top(m.regime()), 1};
                    for (const int order : {4, 15, 16, 33}) {
                        smallest = std::min(smallest, mpfr(bounds.norm(order) / uniform_norm(m, order)));
                    }
                }
                return by_test(smallest >= 1, smallest);
            }};
}

claim two_columns_are_the_motion() {
    return {
        .name = "two_columns_are_the_motion",
        .label = "libration: uniform resummation",
        .statement = "Next to E = 2 the two columns alone are the whole motion: what no coefficient mends is |2-E|/8.",
        .number = "largest |norm/(|2-E|/8) - 1| at gaps +-1e-100, N = 8",
        .correction = "",
        .command = "./run study uniform --gaps 1e-100,-1e-100 --orders 4",
        .measure = [] {
            mpfr worst(0);
            for (const motion& m : {of_gap("1e-100"), motion::of_energy(rational(2 + fraction("1e-100")))}) {
                const mpfr norm = uniform_norm(m, 8);
                worst = std::max(worst, mpfr(abs(norm * 8 / number("1e-100") - 1)));
            }
            return by_test(worst < number("1e-6"), worst);
        }};
}

claim resummation_keeps_the_rate() {
    return {
        .name = "resummation_keeps_the_rate",
        .label = "libration: rates",
        .statement =
            "The paper's resummation has the rate T*/R of the series: its gain is a power of N, so that both slow down "
            "towards E = 2.",
        .number = "(norm at N + 100 over norm at N)^(1/100) over T*/R, times (3/2)^(3/100), N = 200, E = 1.71",
        .correction = "",
        .command = "./run study resummations --energies 1.71 --orders 8,16,32",
        .measure = [] {
            const motion m = of_energy("1.71");
            const precision_scope enough(100);
            arc_errors errors(m);
            const auto largest = [&](int order) {
                mpfr all(0);
                for (int n = order; n < order + 6; ++n) {
                    all = std::max(all, errors.norm(arc_method::resummed, n).norm);
                }
                return all;
            };
            const mpfr power = pow(mpfr(mpfr(3) / 2), mpfr(mpfr(3) / 100));
            const mpfr measured = pow(mpfr(largest(300) / largest(200)), mpfr(mpfr(1) / 100)) * power;
            const mpfr ratio = measured / errors.bounds().rho;
            return by_test(abs(ratio - 1) < mpfr(1) / 100, ratio);
        }};
}

claim two_point_diverges() {
    return {.name = "two_point_diverges",
            .label = "libration: rates",
            .statement =
                "The two-point expansion (as many derivatives at the bottom as at the top) has the rate T*^2/(4 K~' R) "
                "a pair of coefficients, and diverges where |2-E| < 7.74e-5.",
            .number = "norm at N = 80 over norm at N = 40, 2 - E = 1e-6",
            .correction = "",
            .command = "./run study resummations --gaps 1e-3,1e-6 --orders 8,16,32",
            .measure = [] {
                const precision_scope enough(120);
                const auto growth = [](const motion& m) {
                    arc_errors errors(m);
                    const auto norm = [&](int n) {
                        return errors.norm_of(two_point_from_top(errors.arc(), n), 2 * n).norm;
                    };
                    return mpfr(norm(80) / norm(40));
                };
                const auto rate = [](const motion& m) {
                    return two_point_rate(top_bounds<mpfr>::of(energy_level_of<mpfr>(m)));
                };
                const bool edge = rate(of_gap("7.75e-5")) < 1 && rate(of_gap("7.74e-5")) > 1;
                const mpfr grown = growth(of_gap("1e-6"));
                return by_test(edge && grown > 1 && growth(of_gap("1e-3")) < mpfr(1) / 100, grown);
            }};
}

}  // namespace

std::vector<claim> claims_of_libration() {
    return {uniform_rate_below_third(),   sixteen_coefficients(),       uniform_bound(),
            two_columns_are_the_motion(), resummation_keeps_the_rate(), two_point_diverges()};
}

}  // namespace libration
