// Section IV: the rate of convergence of the resummation, the figure of its errors, and its cost compared with the
// series.
#include <algorithm>
#include <string_view>
#include <vector>

#include "claim.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace series;
using namespace pendulum;

using namespace judging;

namespace {

claim acceleration_rate() {
    return {.name = "acceleration_rate",
            .label = "sec:approximant, text",
            .statement = "The resummation accelerates the convergence of the series.",
            .number = "rate per order of the resummation over that of the series, N = 40, 42 to 80, 82, E = 1.71",
            .correction =
                "Both converge at the same rate T*/R, which nothing at T* can change; the norm gains a factor "
                "about (e^2/4)(K~'/T*)^2 N^2 (0.5 to 4.9 times that), which is algebraic.",
            .command = "./run study error_norm --energies 1.71 --orders 40,80 --scalar mpfr:20",
            .measure = [] {
                const sampled_arc arc(of_energy("1.71"));
                // The larger one of two orders: a single one may be near a zero of sin(n phi).
                const auto rate = [](const auto& norm) {
                    const mpfr early = std::max(norm(40), norm(42));
                    const mpfr late = std::max(norm(80), norm(82));
                    return pow(mpfr(late / early), mpfr(mpfr(1) / 40));
                };
                const auto series_norm = [&](int n) { return arc.error_norm(arc.cut(n)); };
                const auto resummed_norm = [&](int n) { return arc.error_norm(arc.resummed(n)); };
                const mpfr ratio = rate(resummed_norm) / rate(series_norm);
                const mpfr gain = series_norm(80) / resummed_norm(80);
                const bool faster = ratio < mpfr(95) / 100;
                return by_tests(faster, gain > 1, ratio);
            }};
}

claim every_energy() {
    return {
        .name = "every_energy",
        .label = "sec:approximant, text",
        .statement =
            "The restriction of the initial conditions does not restrict the energy: librations and rotations "
            "of every energy are reached.",
        .number = "largest error at N = 160 over that at N = 80; E = 1e-3, 1, 4, 100, 2 +- 1e-4, corrected constants",
        .correction = "",
        .command = "./run study error_norm --energies 1,1.9999,2.0001,4 --orders 80,160 --scalar mpfr:20",
        .measure = [] {
            mpfr slowest(0);
            for (const std::string_view energy : {"1e-3", "1", "4", "100", "1.9999", "2.0001"}) {
                // The digits by which the error falls below theta, where the rate is fastest: (T*/R)^160 at E = 1e-3.
                const precision_scope deeper(200);
                const sampled_arc arc(of_energy(energy));
                slowest = std::max(slowest, mpfr(arc.error_at(arc.resummed(160), mpfr(3) / 4) /
                                                 arc.error_at(arc.resummed(80), mpfr(3) / 4)));
            }
            return by_tests(slowest < mpfr(1) / 100, false, slowest);
        }};
}

claim error_gain() {
    return {
        .name = "error_gain",
        .label = "fig:error",
        .statement = "In the figure the resummation is the better one at each energy and order.",
        .number =
            "smallest norm of the series over that of the resummation, N = 2, 5, 10, 20 at ten energies 0.5 ... 4",
        .correction = "",
        .command =
            "./run study error_norm --energies 0.5,1,1.34,1.71,1.9,1.99,2.01,2.1,3,4 --orders 2,5,10,20 --scalar "
            "mpfr:20",
        .measure = [] {
            mpfr smallest(1000);
            for (const std::string_view energy : {"0.5", "1", "1.34", "1.71", "1.9", "1.99", "2.01", "2.1", "3", "4"}) {
                const sampled_arc arc(of_energy(energy));
                for (const int order : {2, 5, 10, 20}) {
                    smallest =
                        std::min(smallest, mpfr(arc.error_norm(arc.cut(order)) / arc.error_norm(arc.resummed(order))));
                }
            }
            return by_tests(smallest > 1, false, smallest);
        }};
}

claim error_monotone() {
    return {.name = "error_monotone",
            .label = "fig:error",
            .statement = "The error of the resummation grows towards E = 2 at every order.",
            .number = "norm at E = 1.90 over that at E = 1.85, N = 5",
            .correction =
                "Only on the whole: the sign of sin(n phi) in a_n makes the norm fall again and again. At N = 5 it "
                "falls from E = 1.75 on to 1.90, at N = 10 between 0.65 and 0.80, at N = 20 between 0.55 and 0.65; "
                "the dashed curves likewise (N = 5: from 1.8 to 1.95).",
            .command = "./run study error_norm --energies 1.75,1.8,1.85,1.9 --orders 5 --scalar mpfr:20",
            .measure = [] {
                const auto norm = [](std::string_view energy) {
                    const sampled_arc arc(of_energy(energy));
                    return arc.error_norm(arc.resummed(5));
                };
                const mpfr ratio = norm("1.90") / norm("1.85");
                return by_tests(ratio >= 1, norm("1.99") > norm("1.5"), ratio);
            }};
}

// |theta of the Runge-Kutta method - theta| at a time, from the initial state of a motion.
mpfr runge_kutta_error(const motion& m, const exact& time, const mpfr& step) {
    const exact_solution<mpfr> truth(m);
    const auto start = truth(exact{});
    runge_kutta_march<mpfr> march({start.theta, start.omega}, step);
    return abs(march.advance_to(from_exact<mpfr>(time)).value - truth(time).theta);
}

claim numerical_step() {
    return {.name = "numerical_step",
            .label = "fig:error, caption",
            .statement = "The fourth-order Runge-Kutta method with the step 1e-5 is exact to machine precision.",
            .number = "its truncation error at t = 2, E = 1.71: that of the step 1e-2 by the law h^4",
            .correction = "",
            .command = "./run trajectory --energy 1.71 --method rk4 --step 1e-2 --scalar mpfr:30 --times 2",
            .measure = [] {
                const motion m = of_energy("1.71");
                const mpfr coarse = runge_kutta_error(m, read_exact("2"), mpfr(1) / 50);
                const mpfr fine = runge_kutta_error(m, read_exact("2"), mpfr(1) / 100);
                const bool fourth_order = abs(coarse / fine / 16 - 1) < mpfr(1) / 10;
                const mpfr at_step = fine / pow(mpfr(10), 12);
                return by_tests(fourth_order && at_step < epsilon<double>(), false, at_step);
            }};
}

claim numerical_baseline() {
    return {.name = "numerical_baseline",
            .label = "fig:error, caption",
            .statement =
                "The difference between the numerical and the closed solution at E = 2 is one level, the effective "
                "machine precision, drawn as a horizontal line.",
            .number = "log(difference at t = 10 / difference at t = 5)/5 at E = 2, step 1/100",
            .correction =
                "There is no T* at E = 2 to end the interval at, and on the way to the top every error grows like "
                "e^t, whatever made it: the line stands where the (unstated) length of the run puts it. In double with "
                "the step 1e-3 it is about 1.6e-14 at t = 6 and 1.8e-9 at t = 18: a growth by e^11.7.",
            .command = "./run trajectory --energy 2 --method rk4 --scalar double --step 1e-3 --times 2,6,10,14,18",
            .measure = [] {
                const motion m = of_energy("2");
                const mpfr step = mpfr(1) / 100;
                const mpfr growth =
                    log(runge_kutta_error(m, read_exact("10"), step) / runge_kutta_error(m, read_exact("5"), step)) / 5;
                const mpfr tenth = mpfr(1) / 10;
                return by_tests(abs(growth) < tenth, abs(growth - 1) < tenth, growth);
            }};
}

// The first of the orders 5, 10, 15, ... at which the error is below a bound.
template <class Norm>
int order_needed(const Norm& norm, const mpfr& below) {
    int order = 5;
    while (norm(order) >= below) {
        order += 5;
    }
    return order;
}

claim fewer_orders() {
    return {.name = "fewer_orders",
            .label = "fig:librationapproximant",
            .statement = "The resummation reaches the same accuracy with a smaller truncation than the series.",
            .number =
                "N that the series needs for a norm below 0.01 over that of the resummation, in steps of 5, E = 1.9998",
            .correction = "",
            .command = "./run study error_norm --gaps 2e-4 --orders 10,20,30,40,50,60 --scalar mpfr:20",
            .measure = [] {
                const sampled_arc arc(of_energy("1.9998"));
                const mpfr below = mpfr(1) / 100;
                const int series = order_needed([&](int n) { return arc.error_norm(arc.cut(n)); }, below);
                const int resummed = order_needed([&](int n) { return arc.error_norm(arc.resummed(n)); }, below);
                return by_tests(series > resummed, false, mpfr(series) / resummed);
            }};
}

claim figure_orders() {
    return {
        .name = "figure_orders",
        .label = "fig:librationapproximant",
        .statement = "At E = 1.9998 the resummation of order 5, 10 and 20 is better than the series of the same order.",
        .number = "smallest norm of the series over that of the resummation, N = 5, 10, 20",
        .correction = "",
        .command = "./run study error_norm --gaps 2e-4 --orders 5,10,20 --scalar mpfr:20",
        .measure = [] {
            const sampled_arc arc(of_energy("1.9998"));
            mpfr smallest(1000);
            for (const int order : {5, 10, 20}) {
                smallest =
                    std::min(smallest, mpfr(arc.error_norm(arc.cut(order)) / arc.error_norm(arc.resummed(order))));
            }
            return by_tests(smallest > 1, false, smallest);
        }};
}

claim degree_for_degree() {
    return {.name = "degree_for_degree",
            .label = "fig:librationapproximant, truncation",
            .statement = "The resummation is more accurate than the series for the same number of powers of t.",
            .number = "norm of the series of degree 2 over that of the resummation of degree 2 (N = 0), E = 1.34",
            .correction =
                "The resummation of order N has the degree N+2. At the same degree the series is better at N = 0 for E "
                "from 1.15 to 1.53, next to where a_4 or a_6 is 0, and at N = 1 to 4 for some energies (2.165 at N = "
                "1); from N = 5 on the resummation is better at each of 796 energies from 0.05 to 4 with |2-E| >= "
                "5e-5.",
            .command = "./run study error_norm --energies 1.34 --orders 0,2 --scalar mpfr:20",
            .measure = [] {
                const sampled_arc arc(of_energy("1.34"));
                const mpfr ratio = arc.error_norm(arc.cut(2)) / arc.error_norm(arc.resummed(0));
                const mpfr later = arc.error_norm(arc.cut(12)) / arc.error_norm(arc.resummed(10));
                return by_tests(ratio > 1, later > 1, ratio);
            }};
}

claim truncation_degree() {
    return {.name = "truncation_degree",
            .label = "truncation",
            .statement = "Cut after ahat_N the resummation is a polynomial of degree N+2.",
            .number = "its degree at E = 1.71, N = 10",
            .correction = "",
            .command = "./run claims truncation_degree",
            .measure = [] {
                const int order = 10;
                const sampled_arc arc(of_energy("1.71"));
                const jet<mpfr> bottom = arc.exact(mpfr(1));
                const auto polynomial = endpoint_corrected(arc.series(order), {bottom.value, bottom.slope});
                int degree = polynomial.order();
                while (abs(polynomial[degree]) < epsilon<mpfr>() * 100) {
                    --degree;
                }
                return by_tests(degree == order + 2, false, mpfr(degree));
            }};
}

}  // namespace

std::vector<claim> claims_of_resummation_errors() {
    return {acceleration_rate(),  every_energy(), error_gain(),    error_monotone(),    numerical_step(),
            numerical_baseline(), fewer_orders(), figure_orders(), degree_for_degree(), truncation_degree()};
}

}  // namespace libration
