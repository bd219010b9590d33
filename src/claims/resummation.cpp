// Section IV and the appendix: the resummation of the series.
#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/claim.hpp"
#include "claims/way_down.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/runge_kutta.hpp"

namespace libration {

namespace {

mpfr bound_of(const way_down& way, int order) { return top_bounds<mpfr>::of(way.of()).resummation_norm(order); }

// The largest ratio of successive norms of the partial sums.
mpfr slowest_fall(const way_down& way, const std::vector<int>& orders) {
    mpfr slowest(0);
    mpfr before(0);
    for (const int order : orders) {
        const mpfr norm = way.error_norm(way.cut(order));
        slowest = before == 0 ? slowest : std::max(slowest, mpfr(norm / before));
        before = norm;
    }
    return slowest;
}

claim figure_series() {
    return {.name = "figure_series",
            .label = "fig:librationfixed, fig:rotationfixed, fig:librationseries",
            .statement =
                "Started at the top the partial sums converge where those from the bottom diverged, and the orders "
                "shown are better one after the other.",
            .number =
                "largest norm over that of the order before: E = 1.71, N = 2, 4, 6; 2.02, 3, 6, 36; 1.9998, 5, 10, 20",
            .correction =
                "They converge, but not monotonically: at E = 1.71 the norm for N = 4 is 0.372 and that for N = 2 is "
                "0.324, because a_4 and a_6 have opposite signs there. N = 6 is better than both (0.186).",
            .command = "./run study error_norm --energies 1.71 --orders 2,4,6 --scalar mpfr:20",
            .measure = [] {
                const way_down swing(at_energy("1.71"));
                const mpfr slowest = std::max(slowest_fall(swing, {2, 4, 6}),
                                              std::max(slowest_fall(way_down(at_energy("2.02")), {3, 6, 36}),
                                                       slowest_fall(way_down(at_energy("1.9998")), {5, 10, 20})));
                const bool converges = slowest_fall(swing, {6, 60}) < mpfr(1) / 1000;
                return judged(slowest < 1, converges, slowest);
            }};
}

claim figure_parity() {
    return {
        .name = "figure_parity",
        .label = "fig:rotationfixed, fig:librationseries",
        .statement = "The curves for N = 6 and 36 of the rotation and for N = 5 of the libration include a term t^N.",
        .number = "|a_6| + |a_36| at E = 2.02 and |a_5| at E = 1.9998, added",
        .correction =
            "These terms are 0: theta - pi is odd about the top of a rotation and theta even about that of a "
            "libration. The curves are those of N = 5, 35 and 4; the smallest case is a_1 = 0 below E = 2.",
        .command = "./run coefficients --energy 2.02 --order 36",
        .measure = [] {
            // By the recurrence of the paper, which knows nothing of parity, unlike the start of the library's own.
            const auto free_series = [](std::string_view energy, int order) {
                const motion m = at_energy(energy);
                const exact_solution<mpfr> solution(m);
                const auto at = phase_of({expansion_point::place::top, {}}, solution);
                auto start = start_at(solution, at);
                start.of_theta = parity::any;
                return taylor_coefficients(start, order, mpfr(1), recurrence::sine_cosine);
            };
            const auto turn = free_series("2.02", 36);
            const auto swing = free_series("1.9998", 5);
            const mpfr sum = abs(turn[6]) + abs(turn[36]) + abs(swing[5]);
            const mpfr resolution = epsilon<mpfr>() * 1000;
            return judged(sum > resolution, abs(turn[5]) > resolution && abs(swing[4]) > resolution, sum);
        }};
}

claim omegab_libration() {
    return {.name = "omegab_libration",
            .label = "omegab",
            .statement = "The angular velocity at the bottom is omega* = +sqrt(2E) below E = 2.",
            .number = "omega(T*)/sqrt(2E) of the exact solution from rest at +arccos(1-E), E = 1.71",
            .correction =
                "omega* = -sqrt(2E): a bob released at a positive angle falls towards smaller ones. At E = 1, "
                "omega(T*) = -1.4142.",
            .command = "./run trajectory --energy 1.71 --times 0,T/4",
            .measure = [] {
                const way_down way(at_energy("1.71"));
                const mpfr speed = way.exact(mpfr(1)).slope / way.period();
                const mpfr ratio = speed / way.fastest();
                const mpfr resolution = epsilon<mpfr>() * 100;
                return judged(abs(ratio - 1) < resolution, abs(ratio + 1) < resolution, ratio);
            }};
}

claim omegab_rotation() {
    return {.name = "omegab_rotation",
            .label = "omegab",
            .statement = "Above E = 2 it is +sqrt(2E) counterclockwise and -sqrt(2E) clockwise.",
            .number = "omega(T*)/sqrt(2E) of the exact clockwise rotation from the top, E = 2.02",
            .correction = "",
            .command = "./run trajectory --energy 2.02 --direction - --times 0,T/2",
            .measure = [] {
                mpfr ratio;
                bool both = true;
                for (const int direction : {1, -1}) {
                    const way_down way(at_energy("2.02", direction));
                    ratio = way.exact(mpfr(1)).slope / way.period() / way.fastest();
                    both = both && abs(ratio - direction) < epsilon<mpfr>() * 100;
                }
                return judged(both, false, ratio);
            }};
}

claim omegab_rate() {
    return {
        .name = "omegab_rate",
        .label = "resummation, omegab",
        .statement = "With omega* of (omegab) the resummation of a libration converges at the series' geometric rate.",
        .number = "norm of the error with omega* = +sqrt(2E) over 2 sqrt(2E) T*/(e N), E = 1.71, N = 100",
        .correction =
            "With the + as printed the error falls only like 2 sqrt(2E) T*/(e N); with omega* = -sqrt(2E) it "
            "stays below the bound A2, which falls like (T*/R)^N. At E = 1.71 and N = 0 the norms are "
            "2.33 and 0.110.",
        .command = "./run claims omegab_rate",
        .measure = [] {
            const int order = 100;
            const way_down way(at_energy("1.71"));
            const mpfr bound = bound_of(way, order);
            const mpfr printed = way.error_norm(way.resummed(order, mpfr(0), way.fastest()));
            const mpfr corrected = way.error_norm(way.resummed(order, mpfr(0), mpfr(-way.fastest())));
            const mpfr slow = way.fastest() * way.period() * 2 / (exp(mpfr(1)) * order);
            return judged(printed < bound, corrected < bound, printed / slow);
        }};
}

claim resummation_counterclockwise() {
    return {.name = "resummation_counterclockwise",
            .label = "resummation",
            .statement = "omega*(t-T*) + (t-T*)^2 sum ahat_n t^n is the counterclockwise rotation.",
            .number = "norm of its error on [0, T*], E = 2.02, N = 20",
            .correction =
                "theta* = 2 pi has to be added: the rotation from (pi, +sqrt(2E-4)) reaches the bottom at 2 pi, "
                "where the printed form is 0 at every N, N = 0 too.",
            .command = "./run trajectory --energy 2.02 --times 0,T/2",
            .measure = [] {
                const int order = 20;
                const way_down way(at_energy("2.02"));
                const mpfr bound = bound_of(way, order);
                const mpfr printed = way.error_norm(way.resummed(order, mpfr(0), way.fastest()));
                const mpfr corrected = way.error_norm(way.resummed(order, mpfr(pi<mpfr>() * 2), way.fastest()));
                return judged(printed < bound, corrected < bound, printed);
            }};
}

claim resummation_clockwise() {
    return {.name = "resummation_clockwise",
            .label = "resummation",
            .statement = "omega*(t-T*) + (t-T*)^2 sum ahat_n t^n is the clockwise rotation.",
            .number = "norm of its error on [0, T*] over the bound A2, E = 2.02, N = 40",
            .correction = "",
            .command = "./run trajectory --energy 2.02 --direction - --method resummed --order 40 --times T/4,T/2",
            .measure = [] {
                const int order = 40;
                const way_down way(at_energy("2.02", -1));
                const mpfr ratio =
                    way.error_norm(way.resummed(order, mpfr(0), mpfr(-way.fastest()))) / bound_of(way, order);
                return judged(ratio < 1, false, ratio);
            }};
}

claim b_constants() {
    return {.name = "b_constants",
            .label = "b",
            .statement =
                "b_0 = a_0 + T* omega*, b_1 = a_1 - omega*, b_n = a_n leave a double zero at T*, so that they can "
                "be divided by (t-T*)^2.",
            .number = "sum b_n T*^n of the counterclockwise rotation, E = 2.02",
            .correction =
                "b_0 = a_0 - theta* + T* omega*, theta* = 2 pi for counterclockwise rotation and 0 otherwise, with "
                "omega* = -sqrt(2E) below 2. As printed sum b_n T*^n = 2 pi at every E > 2.",
            .command = "./run claims b_constants",
            .measure = [] {
                const way_down way(at_energy("2.02"));
                // The sum of all b_n T*^n is theta(T*) less the line there; of n b_n T*^n, its slope.
                const jet<mpfr> bottom = way.exact(mpfr(1));
                const mpfr slope = bottom.slope - way.fastest() * way.period();
                const bool flat = abs(slope) < epsilon<mpfr>() * 100;
                const mpfr rest = bottom.value - pi<mpfr>() * 2;
                return judged(flat && abs(bottom.value) < epsilon<mpfr>() * 100,
                              flat && abs(rest) < epsilon<mpfr>() * 100, bottom.value);
            }};
}

// The formula of (approxcoeffs) as it stands, in the unscaled variable.
std::vector<mpfr> ahat_by_the_formula(const std::vector<mpfr>& b, const mpfr& period) {
    std::vector<mpfr> ahat(b.size(), mpfr(0));
    for (std::size_t n = 0; n < b.size(); ++n) {
        for (std::size_t k = 0; k <= n; ++k) {
            ahat[n] += b[n - k] * static_cast<int>(k + 1) * pow(mpfr(1 / period), static_cast<int>(k) + 2);
        }
    }
    return ahat;
}

// (resummation) at t.
mpfr printed_sum(std::vector<mpfr> ahat, const mpfr& t, const mpfr& period, const mpfr& speed) {
    const mpfr sum = evaluate(power_series<mpfr>(std::move(ahat)), t).value;
    return speed * (t - period) + (t - period) * (t - period) * sum;
}

claim square_expansion() {
    return {.name = "square_expansion",
            .label = "beforeproduc",
            .statement = "(t-T*)^-2 is the sum of (n+1) T*^-(n+2) t^n.",
            .number = "(t-T*)^2 times the sum to n = 200 at t = T*/2, E = 1.71",
            .correction = "",
            .command = "./run claims square_expansion",
            .measure = [] {
                const mpfr period = way_down(at_energy("1.71")).period();
                const mpfr t = period / 2;
                mpfr sum(0);
                for (int n = 200; n >= 0; --n) {
                    sum = sum * t + pow(mpfr(1 / period), n + 2) * (n + 1);
                }
                const mpfr product = sum * (t - period) * (t - period);
                return judged(abs(product - 1) < epsilon<mpfr>() * 1000, false, product);
            }};
}

claim approxcoeffs() {
    return {.name = "approxcoeffs",
            .label = "approxcoeffs",
            .statement = "ahat_n = sum_k b_(n-k) (k+1) T*^-(k+2) are the coefficients of the resummation.",
            .number = "|theta_40 - theta| at 9 T*/10 by this sum over the bound A2, E = 1.71, omega* = -sqrt(2E)",
            .correction = "",
            .command = "./run trajectory --energy 1.71 --method resummed --order 40 --times T/8,9T/40",
            .measure = [] {
                const int order = 40;
                const way_down way(at_energy("1.71"));
                const mpfr speed = -way.fastest();
                auto b = rescale(way.series(order), mpfr(1 / way.period())).coefficients();
                b[0] += way.period() * speed;
                b[1] -= speed;
                auto ahat = ahat_by_the_formula(b, way.period());
                const mpfr place = mpfr(9) / 10;
                const mpfr value = printed_sum(std::move(ahat), mpfr(way.period() * place), way.period(), speed);
                const mpfr ratio = abs(value - way.exact(place).value) / bound_of(way, order);
                return judged(ratio < 1, false, ratio);
            }};
}

claim exact_resummation() {
    return {.name = "exact_resummation",
            .label = "resummation, text",
            .statement = "The infinite sum of ahat_n t^n converges for |t| <= T* as the series does.",
            .number = "ahat_n T*^(n+1)/(2 sqrt(2E)) with the printed omega*, E = 1.71, n = 150",
            .correction =
                "True with omega* = -sqrt(2E), where T* is no singularity. With the printed sign a simple pole is "
                "left at T*: ahat_n T*^(n+1) tends to 2 sqrt(2E), and at t = T* the terms do not even tend to 0 "
                "(E = 1.71: they are within 1% of it from n = 10 on).",
            .command = "./run claims exact_resummation",
            .measure = [] {
                const int order = 150;
                const way_down way(at_energy("1.71"));
                const auto printed = way.resummed(order, mpfr(0), way.fastest()).inner();
                const auto corrected = way.resummed(order).inner();
                const mpfr scale = way.fastest() * way.period() * 2;
                // |ahat_n T*^(n+2)| falls like (T*/R)^n where the radius is R; 100 leaves room for the constant.
                const mpfr allowed = pow(way.rho(), order) * 100;
                return judged(abs(printed[order]) < allowed, abs(corrected[order]) < allowed, printed[order] / scale);
            }};
}

claim resummation_range() {
    return {.name = "resummation_range",
            .label = "resummation",
            .statement = "The resummation converges to theta for |t| <= T*, before the top too.",
            .number = "|theta_80 - theta| at t = -T*, E = 1.71, omega* = -sqrt(2E)",
            .correction = "",
            .command = "./run claims resummation_range",
            .measure = [] {
                const way_down way(at_energy("1.71"));
                // At -T* the monomial t^(N+1+j) leaves 2j - 1 + (-1)^j times itself: the rate stays, nothing is gained.
                const mpfr there(-1);
                const mpfr at_eighty = way.error_at(way.resummed(80), there);
                const mpfr at_forty = way.error_at(way.resummed(40), there);
                const mpfr rate = pow(way.rho(), 40);
                return judged(at_eighty < at_forty * rate * 10, false, at_eighty);
            }};
}

// The exponent p of an error that goes like distance^p.
mpfr order_of_contact(const mpfr& near, const mpfr& far) { return log10(far / near); }

claim enforced_at_top() {
    return {.name = "enforced_at_top",
            .label = "sec:approximant, text",
            .statement = "The resummation keeps the behaviour of the series at t = 0, up to t^N.",
            .number = "the power of t with which the error starts, E = 1.71, N = 10",
            .correction = "",
            .command = "./run claims enforced_at_top",
            .measure = [] {
                const int order = 10;
                const way_down way(at_energy("1.71"));
                const auto approximant = way.resummed(order);
                const mpfr tiny = mpfr(1) / 1000;
                const mpfr power =
                    order_of_contact(way.error_at(approximant, mpfr(tiny / 10)), way.error_at(approximant, tiny));
                return judged(abs(power - (order + 1)) < mpfr(1) / 100, false, power);
            }};
}

claim enforced_at_bottom() {
    return {.name = "enforced_at_bottom",
            .label = "sec:approximant, text",
            .statement = "It has the behaviour of theta at T* by construction, which the series has not.",
            .number = "the power of T*-t with which the error starts, E = 1.71, N = 10, omega* = -sqrt(2E)",
            .correction = "",
            .command = "./run claims enforced_at_bottom",
            .measure = [] {
                const int order = 10;
                const way_down way(at_energy("1.71"));
                const auto approximant = way.resummed(order);
                const mpfr tiny = mpfr(1) / 10000;
                const mpfr power = order_of_contact(way.error_at(approximant, mpfr(1 - tiny / 10)),
                                                    way.error_at(approximant, mpfr(1 - tiny)));
                const bool series_misses = way.error_at(way.cut(order), mpfr(1)) > mpfr(1) / 1000;
                return judged(abs(power - 2) < mpfr(1) / 100 && series_misses, false, power);
            }};
}

// theta_N''(T*) = 2 sum ahat_n T*^n.
mpfr curvature_at_bottom(const way_down& way, int order) {
    return evaluate(way.resummed(order).inner(), mpfr(1)).value * 2 / (way.period() * way.period());
}

claim second_derivative() {
    return {.name = "second_derivative",
            .label = "sec:approximant, text",
            .statement = "At T* the resummation matches theta up to the second derivative.",
            .number = "theta_N''(T*), which is 0 for theta, E = 1.71, N = 10",
            .correction =
                "Up to the first: value and slope are two conditions. theta''(T*) = -sin theta* = 0 by the "
                "equation, but theta_N''(T*) = 2 sum ahat_n T*^n is not; at E = 1.71 and N = 0 it is -0.722.",
            .command = "./run claims second_derivative",
            .measure = [] {
                const way_down way(at_energy("1.71"));
                const int order = 10;
                const jet<mpfr> end = way.resummed(order)(mpfr(1));
                const jet<mpfr> bottom = way.exact(mpfr(1));
                const mpfr resolution = epsilon<mpfr>() * 10000;  // sums of 10 terms of size 1
                const bool tangent =
                    abs(end.value - bottom.value) < resolution && abs(end.slope - bottom.slope) < resolution;
                const mpfr curvature = curvature_at_bottom(way, order);
                return judged(tangent && abs(curvature) < resolution, tangent, curvature);
            }};
}

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
                const way_down way(at_energy("1.71"));
                // The larger one of two orders: one alone may be near a zero of sin(n phi).
                const auto rate = [](const auto& norm) {
                    const mpfr early = std::max(norm(40), norm(42));
                    const mpfr late = std::max(norm(80), norm(82));
                    return pow(mpfr(late / early), mpfr(mpfr(1) / 40));
                };
                const auto series_norm = [&](int n) { return way.error_norm(way.cut(n)); };
                const auto resummed_norm = [&](int n) { return way.error_norm(way.resummed(n)); };
                const mpfr ratio = rate(resummed_norm) / rate(series_norm);
                const mpfr gain = series_norm(80) / resummed_norm(80);
                const bool faster = ratio < mpfr(95) / 100;
                return judged(faster, gain > 1, ratio);
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
                // The digits that the error falls below theta, where the rate is fastest: (T*/R)^160 at E = 1e-3.
                const precision_scope deeper(200);
                const way_down way(at_energy(energy));
                slowest = std::max(slowest, mpfr(way.error_at(way.resummed(160), mpfr(3) / 4) /
                                                 way.error_at(way.resummed(80), mpfr(3) / 4)));
            }
            return judged(slowest < mpfr(1) / 100, false, slowest);
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
                const way_down way(at_energy(energy));
                for (const int order : {2, 5, 10, 20}) {
                    smallest =
                        std::min(smallest, mpfr(way.error_norm(way.cut(order)) / way.error_norm(way.resummed(order))));
                }
            }
            return judged(smallest > 1, false, smallest);
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
                    const way_down way(at_energy(energy));
                    return way.error_norm(way.resummed(5));
                };
                const mpfr ratio = norm("1.90") / norm("1.85");
                return judged(ratio >= 1, norm("1.99") > norm("1.5"), ratio);
            }};
}

// |theta of the Runge-Kutta method - theta| at a time, from the start of a motion.
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
                const motion m = at_energy("1.71");
                const mpfr coarse = runge_kutta_error(m, read_exact("2"), mpfr(1) / 50);
                const mpfr fine = runge_kutta_error(m, read_exact("2"), mpfr(1) / 100);
                const bool fourth_order = abs(coarse / fine / 16 - 1) < mpfr(1) / 10;
                const mpfr at_step = fine / pow(mpfr(10), 12);
                return judged(fourth_order && at_step < epsilon<double>(), false, at_step);
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
                const motion m = at_energy("2");
                const mpfr step = mpfr(1) / 100;
                const mpfr growth =
                    log(runge_kutta_error(m, read_exact("10"), step) / runge_kutta_error(m, read_exact("5"), step)) / 5;
                const mpfr tenth = mpfr(1) / 10;
                return judged(abs(growth) < tenth, abs(growth - 1) < tenth, growth);
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
                const way_down way(at_energy("1.9998"));
                const mpfr below = mpfr(1) / 100;
                const int series = order_needed([&](int n) { return way.error_norm(way.cut(n)); }, below);
                const int resummed = order_needed([&](int n) { return way.error_norm(way.resummed(n)); }, below);
                return judged(series > resummed, false, mpfr(series) / resummed);
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
            const way_down way(at_energy("1.9998"));
            mpfr smallest(1000);
            for (const int order : {5, 10, 20}) {
                smallest =
                    std::min(smallest, mpfr(way.error_norm(way.cut(order)) / way.error_norm(way.resummed(order))));
            }
            return judged(smallest > 1, false, smallest);
        }};
}

claim degree_for_degree() {
    return {.name = "degree_for_degree",
            .label = "fig:librationapproximant, truncation",
            .statement = "The resummation is more accurate than the series for the same number of powers of t.",
            .number = "norm of the series of degree 2 over that of the resummation of degree 2 (N = 0), E = 1.34",
            .correction =
                "The resummation of order N has the degree N+2. At the same degree the series is better at N = 0 for E "
                "from 1.15 to "
                "1.53, next to where a_4 or a_6 is 0, and at N = 1 to 4 for some energies (2.165 at N = 1); from N = 5 "
                "on the "
                "resummation is better at each of 796 energies from 0.05 to 4 with |2-E| >= 5e-5.",
            .command = "./run study error_norm --energies 1.34 --orders 0,2 --scalar mpfr:20",
            .measure = [] {
                const way_down way(at_energy("1.34"));
                const mpfr ratio = way.error_norm(way.cut(2)) / way.error_norm(way.resummed(0));
                const mpfr later = way.error_norm(way.cut(12)) / way.error_norm(way.resummed(10));
                return judged(ratio > 1, later > 1, ratio);
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
                const way_down way(at_energy("1.71"));
                const jet<mpfr> bottom = way.exact(mpfr(1));
                const auto polynomial = endpoint_corrected(way.series(order), {bottom.value, bottom.slope});
                int degree = polynomial.order();
                while (abs(polynomial[degree]) < epsilon<mpfr>() * 100) {
                    --degree;
                }
                return judged(degree == order + 2, false, mpfr(degree));
            }};
}

// theta_N of the appendix from its printed alpha and beta, with the sums sigma_N(T*) - theta* and sigma_N'(T*).
struct appendix_form {
    std::vector<mpfr> coefficients;  // of the powers of t

    appendix_form(std::vector<mpfr> a, const mpfr& period, const mpfr& speed, const jet<mpfr>& sigma)
        : coefficients(std::move(a)) {
        const int order = static_cast<int>(coefficients.size()) - 1;
        const mpfr slope = speed - sigma.slope;
        const auto power = [&](int n) { return pow(mpfr(1 / period), n); };
        coefficients.push_back(-sigma.value * (order + 2) * power(order + 1) - slope * power(order));
        coefficients.push_back(sigma.value * (order + 1) * power(order + 2) + slope * power(order + 1));
    }
};

// sigma_N and sigma_N' at t as (efficient) should have them, and as it prints them, sum a_n t^N.
jet<mpfr> sigma_of(const std::vector<mpfr>& a, const mpfr& t) {
    const auto at = evaluate(power_series<mpfr>(a), t);
    return {at.value, at.slope};
}
jet<mpfr> sigma_as_printed(const std::vector<mpfr>& a, const mpfr& t) {
    const int order = static_cast<int>(a.size()) - 1;
    const mpfr sum = evaluate(power_series<mpfr>(a), mpfr(1)).value;
    return {sum * pow(t, order), sum * pow(t, order - 1) * order};
}

std::vector<mpfr> unscaled(const way_down& way, int order) {
    return rescale(way.series(order), mpfr(1 / way.period())).coefficients();
}

// The norm of theta_N - theta where theta_N is in powers of t.
mpfr norm_of(const way_down& way, const appendix_form& form) {
    const truncated_series<mpfr> scaled(rescale(power_series<mpfr>(form.coefficients), way.period()), mpfr(1));
    return way.error_norm(scaled);
}

claim appendix_sigma() {
    return {.name = "appendix_sigma",
            .label = "efficient",
            .statement = "sigma_N(t) is the sum of a_n t^N.",
            .number = "norm of the error of theta_10 with alpha and beta from this sum, E = 1.71, omega* = -sqrt(2E)",
            .correction =
                "sigma_N(t) = sum of a_n t^n (a misprint: N for n). With it the norm is below the bound A2. Printed "
                "and meant sums are the same only at N = 0; at E = 1.71 and N = 1 they give at T* 5.68 "
                "and 2.36.",
            .command = "./run claims appendix_sigma",
            .measure = [] {
                const int order = 10;
                const way_down way(at_energy("1.71"));
                const auto a = unscaled(way, order);
                const mpfr& t = way.period();
                const mpfr speed = -way.fastest();
                const mpfr printed = norm_of(way, {a, t, speed, sigma_as_printed(a, t)});
                const mpfr corrected = norm_of(way, {a, t, speed, sigma_of(a, t)});
                const mpfr bound = bound_of(way, order);
                return judged(printed < bound, corrected < bound, printed);
            }};
}

claim appendix_alpha_beta() {
    return {
        .name = "appendix_alpha_beta",
        .label = "efficient",
        .statement = "alpha and beta, given by sigma_N(T*), sigma_N'(T*) and omega*, make theta_N end as theta does.",
        .number = "norm of the error of the counterclockwise rotation, E = 2.02, N = 11",
        .correction =
            "sigma_N(T*) - theta* has to stand for sigma_N(T*) in both, theta* = 2 pi for counterclockwise "
            "rotation: at E = 2.02 they end at 0 instead of 2 pi at every N. For libration (with "
            "omega* = -sqrt(2E)) and clockwise rotation they are right.",
        .command = "./run claims appendix_alpha_beta",
        .measure = [] {
            const int order = 11;
            const way_down way(at_energy("2.02"));
            const auto a = unscaled(way, order);
            const mpfr& t = way.period();
            jet<mpfr> sigma = sigma_of(a, t);
            const mpfr printed = norm_of(way, {a, t, way.fastest(), sigma});
            sigma.value -= pi<mpfr>() * 2;
            const mpfr corrected = norm_of(way, {a, t, way.fastest(), sigma});
            const mpfr bound = bound_of(way, order);
            return judged(printed < bound, corrected < bound, printed);
        }};
}

claim appendix_conditions() {
    return {.name = "appendix_conditions",
            .label = "sec:A1, text",
            .statement = "alpha and beta follow from the first and second derivative at T*.",
            .number = "theta_N(T*) when alpha, beta give theta_N'(T*) = omega*, theta_N''(T*) = 0; E = 1.71, N = 10",
            .correction =
                "From the value and the first derivative, and so are the printed formulas. The first and second "
                "derivative of theta would leave the value at T* wrong: at E = 1.71 and N = 0 the value is "
                "a_0 - sqrt(2E) T* = -2.09 instead of 0.",
            .command = "./run claims appendix_conditions",
            .measure = [] {
                const int order = 10;
                const way_down way(at_energy("1.71"));
                const auto a = way.series(order);
                // In x = t/T*: A and B with (N+1) A + (N+2) B = slope, (N+1) N A + (N+2)(N+1) B = curvature.
                mpfr slope = -way.fastest() * way.period();
                mpfr curvature(0);
                mpfr value(0);
                for (int n = 0; n <= order; ++n) {
                    value += a[n];
                    slope -= a[n] * n;
                    curvature -= a[n] * n * (n - 1);
                }
                const mpfr second = (curvature - slope * order) / (order + 2);
                const mpfr first = (slope - second * (order + 2)) / (order + 1);
                const mpfr end = value + first + second;
                const mpfr printed = way.resummed(order)(mpfr(1)).value;
                return judged(abs(end) < epsilon<mpfr>() * 10000, abs(printed) < epsilon<mpfr>() * 10000, end);
            }};
}

claim appendix_same_polynomial() {
    return {.name = "appendix_same_polynomial",
            .label = "truncation2",
            .statement = "a_0 ... a_N with alpha and beta are the same polynomial as the resummation cut after ahat_N.",
            .number = "decimal digits to which both agree on [0, T*], E = 1.71, N = 20, 50 digits carried",
            .correction = "",
            .command = "./run claims appendix_same_polynomial",
            .measure = [] {
                const int order = 20;
                const way_down way(at_energy("1.71"));
                const auto a = unscaled(way, order);
                const mpfr& t = way.period();
                const appendix_form form(a, t, mpfr(-way.fastest()), sigma_of(a, t));
                const truncated_series<mpfr> corrected(rescale(power_series<mpfr>(form.coefficients), t), mpfr(1));
                const auto factored = way.resummed(order);
                mpfr largest = epsilon<mpfr>();
                for (int i = 0; i <= 20; ++i) {
                    const mpfr x = mpfr(i) / 20;
                    largest = std::max(largest, mpfr(abs(corrected(x).value - factored(x).value)));
                }
                const mpfr agreed = -log10(largest);
                return judged(agreed > 45, false, agreed);
            }};
}

claim appendix_second_product() {
    return {
        .name = "appendix_second_product",
        .label = "sec:A1, text",
        .statement = "The coefficients ahat_n cost a second quadratic step, which only the recast form avoids.",
        .number = "decimal digits to which two running sums agree with (approxcoeffs), E = 1.71, N = 100, 50 carried",
        .correction =
            "Dividing by (1 - t/T*)^2 is dividing by 1 - t/T* twice: with b_n T*^n the ahat_n T*^(n+2) are two "
            "running sums, 2N additions and no product, where (approxcoeffs) takes (N+1)(N+2)/2 products; "
            "already at N = 1 it is 1 addition twice against 3.",
        .command = "./run claims appendix_second_product",
        .measure = [] {
            const int order = 100;
            const way_down way(at_energy("1.71"));
            const std::vector<mpfr> end{mpfr(0), mpfr(-way.fastest() * way.period())};
            const auto series = way.series(order);
            const auto sums = inner_series(series, end);
            const auto product = inner_series_by_convolution(series, end);
            mpfr largest = epsilon<mpfr>();
            for (int n = 0; n <= order; ++n) {
                largest = std::max(largest, mpfr(abs(sums[n] - product[n])));
            }
            const mpfr agreed = -log10(largest);
            return judged(agreed<40, agreed> 40, agreed);
        }};
}

claim appendix_saving() {
    return {.name = "appendix_saving",
            .label = "sec:A1, text",
            .statement = "Leaving out the second quadratic step saves a substantial part of the time.",
            .number = "products of (approxcoeffs) over all products of (pendseries) and (approxcoeffs), N = 1000",
            .correction = "",
            .command = "./run claims appendix_saving",
            .measure = [] {
                const int order = 1000;
                long recursion = 0;
                for (int n = 0; n + 2 < order; ++n) {
                    recursion += 2L * (n + 1);  // s_(n+1) and c_(n+1), for a_(n+2)
                }
                long convolution = 0;
                for (int n = 0; n <= order; ++n) {
                    convolution += n + 1;
                }
                const mpfr share = mpfr(convolution) / (recursion + convolution);
                return judged(share > mpfr(1) / 4, false, share);
            }};
}

claim appendix_range() {
    return {.name = "appendix_range",
            .label = "sec:A1, text",
            .statement = "The form with T*^-N and a_n serves for any finite truncation, in any code.",
            .number = "error at 0.99 T* at the first N with T*^(N+1) beyond the range of double, gap 1e-10 (N = 274)",
            .correction =
                "In double only as far as its range: T*^(N+1) > 1.8e308 from N = 274 on at 2-E = 1e-10, where the "
                "error is still far above the rounding, and a_n < 2.2e-308 from about there too. In t/T* (a_n T*^n "
                "for a_n) nothing leaves it.",
            .command = "./run study error_norm --gaps 1e-10 --orders 273,274 --scalar mpfr:20",
            .measure = [] {
                const precision_scope enough(30);
                const way_down way(at_gap("1e-10"));
                const mpfr largest = mpfr(std::numeric_limits<double>::max());
                int order = 0;
                for (mpfr power = way.period(); power <= largest; power *= way.period()) {
                    ++order;
                }
                const mpfr error = way.error_at(way.resummed(order), mpfr(mpfr(99) / 100));
                const auto scaled = way.series(400);
                mpfr widest(0);
                for (int n = 0; n <= 400; ++n) {
                    widest = std::max(widest, mpfr(abs(scaled[n])));
                }
                return judged(error < epsilon<double>(), widest < 100, error);
            }};
}

}  // namespace

std::vector<claim> claims_of_resummation() {
    return {figure_series(),
            figure_parity(),
            omegab_libration(),
            omegab_rotation(),
            omegab_rate(),
            resummation_counterclockwise(),
            resummation_clockwise(),
            b_constants(),
            square_expansion(),
            approxcoeffs(),
            exact_resummation(),
            resummation_range(),
            enforced_at_top(),
            enforced_at_bottom(),
            second_derivative(),
            acceleration_rate(),
            every_energy(),
            error_gain(),
            error_monotone(),
            numerical_step(),
            numerical_baseline(),
            fewer_orders(),
            figure_orders(),
            degree_for_degree(),
            truncation_degree(),
            appendix_sigma(),
            appendix_alpha_beta(),
            appendix_conditions(),
            appendix_same_polynomial(),
            appendix_second_product(),
            appendix_saving(),
            appendix_range()};
}

}  // namespace libration
