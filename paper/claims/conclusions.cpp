// Section VI: the conclusions of the paper.
#include <algorithm>
#include <string_view>

#include "claim.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace series;
using namespace convergence;
using namespace pendulum;

using namespace judging;

namespace {

claim converges_beyond_bottom() {
    return {.name = "converges_beyond_bottom",
            .label = "sec:conclusions",
            .statement =
                "From the top the series converges beyond the bottom, so that the pendulum is in the first of three "
                "scenarios: a radius larger than the domain.",
            .number = "smallest R/T* - 1 over E = 0.1, 1, 1.71, 4, 100 and gaps +-1e-10, 1e-100",
            .correction = "",
            .command = "./run coefficients --gap 1e-10 --order 20",
            .measure = [] {
                const precision_scope enough(150);
                mpfr smallest(1000);
                for (const std::string_view energy : {"0.1", "1", "1.71", "4", "100", "2.0000000001"}) {
                    smallest = std::min(smallest, mpfr(1 / sampled_arc(of_energy(energy)).rho()));
                }
                for (const std::string_view gap : {"1e-10", "1e-100"}) {
                    smallest = std::min(smallest, mpfr(1 / sampled_arc(of_gap(gap)).rho()));
                }
                // R is the distance of the singularities; the coefficients show that the series does converge there.
                const sampled_arc arc(of_energy("1.71"));
                const bool terms_fall = abs(arc.series(200)[200]) < abs(arc.series(100)[100]) / 1000;
                const mpfr beyond = smallest - 1;
                return by_tests(beyond > 0 && terms_fall, false, beyond);
            }};
}

claim optimal_at_top() {
    return {.name = "optimal_at_top",
            .label = "sec:conclusions",
            .statement = "The series converges best when it starts at the top.",
            .number = "T*/2R about the middle of the descent over T*/R about the top, E = 1.71",
            .correction =
                "The radius is largest there. For the descent from top to bottom, an expansion about its middle has to "
                "reach only T*/2: its error falls with T*/2R there, which is smaller at every energy; at E = 1.71 "
                "0.593 against 0.827. Per nonzero coefficient the top is better for E < 6 - 4 sqrt 2 and E > 6 + 4 "
                "sqrt 2 (top_is_the_best_point).",
            .command = "./run coefficients --energy 1.71 --order 20 --at T/8",
            .measure = [] {
                bool largest_at_top = true;
                mpfr ratio;
                for (const std::string_view energy : {"0.5", "4", "1.71"}) {
                    const sampled_arc arc(of_energy(energy));
                    const mpfr half = arc.period() / 2;
                    const mpfr radius = sqrt(half * half + arc.height() * arc.height());
                    largest_at_top = largest_at_top && radius < arc.radius();
                    ratio = half / radius / arc.rho();
                }
                return by_tests(ratio > 1, largest_at_top, ratio);
            }};
}

claim better_at_every_truncation() {
    return {.name = "better_at_every_truncation",
            .label = "sec:conclusions",
            .statement = "The resummation is more accurate than the series for any truncation and any energy.",
            .number = "norm of the series over that of the resummation, 2 - E = 1e-8, N = 0",
            .correction =
                "Not next to E = 2 for a fixed N: there the norm of the series stays below pi, while that of the "
                "resummation grows with T*. Smallest: N = 0 from |2-E| = 1.59e-8 on (at 1e-8: 3.254 against 3.141), N "
                "= 1 from about 8e-15. At the energies of the figure and at the same N it holds in "
                "the norm (the factor is 1.46 at least, at E = 1.34, N = 2).",
            .command = "./run study error_norm --gaps 1e-8,1e-15 --orders 0,1 --scalar mpfr:20",
            .measure = [] {
                const sampled_arc near(of_gap("1e-8"));
                const mpfr ratio = near.error_norm(near.cut(0)) / near.error_norm(near.resummed(0));
                return by_tests(ratio > 1, false, ratio);
            }};
}

claim better_at_every_time() {
    return {.name = "better_at_every_time",
            .label = "sec:conclusions",
            .statement = "The resummation is more accurate from the top to the bottom, at every time.",
            .number = "error of the resummation over that of the series at t = T*/100, E = 1.71, N = 4",
            .correction =
                "In the maximum over [0, T*]. Near the top its error begins with t^(N+1), that of the series with "
                "t^(N+2) where the parity of theta leaves out N+1 (N even below 2, odd above): smallest N = 0, where "
                "at E = 1.71 and t = T*/100 the errors are 2.7e-3 and 2.0e-4.",
            .command = "./run trajectory --energy 1.71 --method resummed --order 4 --times T/400",
            .measure = [] {
                const sampled_arc arc(of_energy("1.71"));
                const mpfr x = mpfr(1) / 100;
                const mpfr ratio = arc.error_at(arc.resummed(4), x) / arc.error_at(arc.cut(4), x);
                const bool in_the_norm = arc.error_norm(arc.resummed(4)) < arc.error_norm(arc.cut(4));
                return by_tests(ratio < 1, in_the_norm, ratio);
            }};
}

claim all_times() {
    return {.name = "all_times",
            .label = "sec:conclusions",
            .statement = "By symmetry the convergent solution gives the motion at all times.",
            .number = "error of the extended resummation at t = 1002, E = 1.71, N = 20, with T* to 50 digits",
            .correction = "",
            .command = "./run trajectory --energy 1.71 --method resummed --order 20 --times 1002",
            .measure = [] {
                const motion m = of_energy("1.71");
                const sampled_arc arc(m);
                const periodic_extension<mpfr, endpoint_approximant<mpfr>> extended(m, arc.resummed(20));
                const exact late = read_exact("1002");
                const mpfr error = abs(extended(late).value - exact_solution<mpfr>(m)(late).theta);
                return by_tests(error < arc.error_norm(arc.resummed(20)) * 2, false, error);
            }};
}

ode::explicit_system blasius() {
    return ode::explicit_system(ode::parse("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1"));
}

power_series<mpfr> blasius_series(int order) {
    const ode::tape tape = ode::tape::about_start(blasius());
    ode::taylor_expansion<mpfr> expansion(tape, order);
    expansion.about_start();
    return expansion.series_of(0);
}

// f'(infinity) of the solution with f''(0) = 1; the rest after eta = 16 is below exp(-60).
mpfr blasius_limit() {
    ode::taylor_march<mpfr> march(blasius());
    return march.advance_to(mpfr(16))[0][1];
}

claim blasius_scenario() {
    return {.name = "blasius_scenario",
            .label = "sec:conclusions",
            .statement = "The radius of convergence of the Blasius series lies within its domain, the half line.",
            .number = "radius in eta from the ratio of its coefficients of order 3n+2 = 302 and 305, f'(infinity) = 1",
            .correction = "",
            .command = "./run claims blasius_scenario",
            .measure = [] {
                // f(eta) = s g(s eta) with g''(0) = 1 and s^2 g'(infinity) = 1 [Toepfer].
                const auto g = blasius_series(305);
                const mpfr radius = cbrt(mpfr(abs(g[302] / g[305])));
                const mpfr earlier = cbrt(mpfr(abs(g[272] / g[275])));
                const mpfr in_eta = radius * sqrt(blasius_limit());
                const bool settled = abs(radius / earlier - 1) < mpfr(1) / 1000;
                return by_tests(settled && in_eta > 0, false, in_eta);
            }};
}

// |a_n| R^n of even n.
mpfr scaled_coefficient(const expansion<mpfr>& e, int n) { return abs(e.scaled[n]); }

expansion<mpfr> series_at_171(int order) {
    return expand(exact_solution<mpfr>(of_energy("1.71")), {expansion_point::place::top, {}}, order);
}

// With c_j = j a_2j, a pure sine of the four nearest singularities: (c_(j+1) c_(j-1) - c_j^2)/(c_j c_(j-2) -
// c_(j-1)^2) is R^-4, up to those behind them. The relative error of R, n = 2j.
mpfr error_of_three_terms(const expansion<mpfr>& e, int n) {
    const auto c = [&](int power) { return mpfr(e.scaled[power] * power); };
    const mpfr quotient = (c(n + 2) * c(n - 2) - c(n) * c(n)) / (c(n) * c(n - 4) - c(n - 2) * c(n - 2));
    return abs(sqrt(sqrt(mpfr(abs(quotient)))) - 1);
}

// R over the distance of the next singularities, T* +- 3i K~' or 3T* +- i K~'.
mpfr rate_of_three_terms(const char* energy) {
    const sampled_arc arc(of_energy(energy));
    const mpfr along = arc.period() * arc.period();
    const mpfr up = arc.height() * arc.height();
    return arc.radius() / sqrt(std::min(mpfr(along + up * 9), mpfr(along * 9 + up)));
}

claim domb_sykes() {
    return {.name = "domb_sykes",
            .label = "sec:conclusions",
            .statement =
                "Where the singularities are not known, ratios of coefficients (a Domb-Sykes plot) give the radius.",
            .number = "largest over smallest sqrt|a_n/a_(n+2)|, n = 300, 302, ..., 400, from the top, E = 1.71",
            .correction =
                "Not for this series: every second a_n is 0, and the ratios of the others do not converge, because "
                "the nearest singularities are four at the angles +-phi, pi +- phi (a_n ~ sin(n phi)/n R^n). The "
                "ratio with three terms (Mercer and Roberts) does, and its error is exponentially small: it falls "
                "like (R/R_2)^n, R_2 the distance of the next singularities, by 0.533 a power of t at E = 1.71. Poles "
                "fitted to n a_n give R and the position alike. Smallest: a_1/a_2 is 0 and a_2/a_3 infinite at every "
                "E < 2.",
            .command = "./run radius --energy 1.71 --order 400",
            .measure = [] {
                const auto e = series_at_171(404);
                mpfr smallest(1000);
                mpfr largest(0);
                for (int n = 300; n <= 400; n += 2) {
                    const mpfr ratio = sqrt(scaled_coefficient(e, n) / scaled_coefficient(e, n + 2));
                    smallest = std::min(smallest, ratio);
                    largest = std::max(largest, ratio);
                }
                // The observed rate of the error of three terms, the larger error of two orders at either end.
                const auto early = std::max(error_of_three_terms(e, 40), error_of_three_terms(e, 42));
                const auto late = std::max(error_of_three_terms(e, 120), error_of_three_terms(e, 122));
                const mpfr rate = pow(mpfr(late / early), mpfr(1) / 80);
                const bool three_terms = abs(rate / rate_of_three_terms("1.71") - 1) < mpfr(5) / 100;
                const mpfr spread = largest / smallest;
                return by_tests(spread < mpfr(105) / 100, three_terms, spread);
            }};
}

claim root_test() {
    return {.name = "root_test",
            .label = "sec:conclusions",
            .statement = "The root test gives the radius numerically.",
            .number = "smallest |a_n|^(-1/n) over R, n = 300 ... 400, from the top, E = 1.71",
            .correction = "",
            .command = "./run radius --energy 1.71 --order 400",
            .measure = [] {
                const auto e = series_at_171(400);
                mpfr smallest(1000);
                for (int n = 300; n <= 400; n += 2) {
                    smallest = std::min(smallest, mpfr(pow(scaled_coefficient(e, n), mpfr(-1) / n)));
                }
                return by_tests(abs(smallest - 1) < mpfr(2) / 100, false, smallest);
            }};
}

// R about the fraction x of the interval between the top and the bottom, relative to the exact value: deduced from 60
// coefficients in time scaled by T*, with 40 digits.
mpfr deduced_radius(const motion& m, const rational& x) {
    const exact_solution<mpfr> solution(m);
    const expansion_point point{expansion_point::place::time,
                                {rational(x / quarters_per_period(m.regime())), unit::period, ""}};
    const phase<mpfr> at = phase_of(point, solution);
    const mpfr tstar = effective_period(energy_level_of<mpfr>(m));
    const auto a = taylor_coefficients(start_at(solution, at), 60, tstar);
    return *verdict_in(a).radius * tstar;
}

claim expansion_point_deduced() {
    return {.name = "expansion_point_deduced",
            .label = "sec:conclusions",
            .statement =
                "Where the singularities are not known, the best point to expand about can be deduced numerically.",
            .number = "largest |R'/R - 1| of radii R' from 60 coefficients, about 0, T*/2, T*, E = 0.5, 1.71, 4",
            .correction = "",
            .command = "./run study radius_map",
            .measure = [] {
                mpfr worst(0);
                bool largest_at_top = true;
                for (const std::string_view energy : {"0.5", "1.71", "4"}) {
                    const sampled_arc arc(of_energy(energy));
                    mpfr before(1000);
                    for (int half = 0; half <= 2; ++half) {
                        const mpfr away = arc.period() * (2 - half) / 2;
                        const mpfr exact = sqrt(away * away + arc.height() * arc.height());
                        const mpfr deduced = deduced_radius(of_energy(energy), rational(half, 2));
                        worst = std::max(worst, mpfr(abs(deduced / exact - 1)));
                        largest_at_top = largest_at_top && deduced < before;
                        before = deduced;
                    }
                }
                return by_tests(largest_at_top && worst < pow(mpfr(10), -10), false, worst);
            }};
}

}  // namespace

std::vector<claim> claims_of_conclusions() {
    return {converges_beyond_bottom(),
            optimal_at_top(),
            better_at_every_truncation(),
            better_at_every_time(),
            all_times(),
            blasius_scenario(),
            domb_sykes(),
            root_test(),
            expansion_point_deduced()};
}

}  // namespace libration
