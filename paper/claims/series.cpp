// Claims of section III A: the recurrences, other derivations of them, and figure `series`.
#include <algorithm>
#include <array>
#include <utility>

#include "judging.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "libration/series/exponential.hpp"

namespace libration {

using namespace series;

namespace {

using namespace judging;

claim pendulum_recurrence() {
    return {
        "pendulum_recurrence",
        "pendcoeffs, pendseries",
        "a_(n+2) = -s_n/((n+1)(n+2)), with s_n and c_n by their recurrences, are the Taylor coefficients of theta from "
        "any initial conditions.",
        "largest |theta'' + sin theta| of the sum to n = 240 at t = +-1/4, from (1, 1/2), (2.5, -0.3), (-3, 4), (9, "
        "0.1), (0, 2)",
        "",
        "./run coefficients --theta0 2.5 --omega0 -0.3 --order 10",
        [] {
            mpfr largest(0);
            const std::array<std::pair<const char*, const char*>, 5> states{
                {{"1", "1/2"}, {"2.5", "-0.3"}, {"-3", "4"}, {"9", "0.1"}, {"0", "2"}}};
            for (const auto& [theta0, omega0] : states) {
                const auto theta = printed_series({number(theta0), number(omega0)}, 240, mpfr(1));
                const auto acceleration = derivative(derivative(theta));
                for (const int sign : {1, -1}) {
                    const mpfr t = mpfr(sign) / 4;
                    const mpfr residual = evaluate(acceleration, t).value + sin(evaluate(theta, t).value);
                    largest = std::max(largest, mpfr(abs(residual)));
                }
            }
            return by_error(largest);
        }};
}

// Largest |series(x) - f(inner(x))| at x = +-1/8.
template <class F>
mpfr distance_at_an_eighth(const power_series<mpfr>& series, const power_series<mpfr>& inner, F f) {
    mpfr largest(0);
    for (const int sign : {1, -1}) {
        const mpfr x = mpfr(sign) / 8;
        largest = std::max(largest, mpfr(abs(evaluate(series, x).value - f(evaluate(inner, x).value))));
    }
    return largest;
}

claim exponential_recurrence_claim() {
    return {"exponential_recurrence",
            "eCoeffs",
            "b_(n+1) = sum (k+1) a_(k+1) b_(n-k)/(n+1), b_0 = e^(a_0), are the coefficients of exp(sum a_n t^n).",
            "largest |sum b_n t^n - exp(sum a_n t^n)| at t = +-1/8, a_n of the motion from (1, 1/2), n <= 100",
            "",
            "./run coefficients --theta0 1 --omega0 1/2 --order 10",
            [] {
                const auto inner = printed_series({mpfr(1), mpfr(1) / 2}, 100, mpfr(1));
                return by_error(
                    distance_at_an_eighth(exponential(inner), inner, [](const mpfr& x) { return mpfr(exp(x)); }));
            }};
}

claim series_labels() {
    return {
        "series_labels",
        "cosseriesrec, sinseriesrec",
        "The recurrence labelled as that of the cosine series gives the coefficients of cos theta, the one of the sine "
        "series those of sin theta.",
        "largest distance of the two sums from these functions at t = +-1/8, from (1, 1/2), n <= 100",
        "The labels are exchanged in the source: the first, for s_(n+1), gives sin theta, the second, for c_(n+1), "
        "cos theta. With theta = t, s_1 = 1 and c_1 = 0.",
        "./run coefficients --theta0 1 --omega0 1/2 --order 10",
        [] {
            const auto inner = printed_series({mpfr(1), mpfr(1) / 2}, 100, mpfr(1));
            const auto [s, c] = sine_cosine(inner);
            const auto sine = [](const mpfr& x) { return mpfr(sin(x)); };
            const auto cosine = [](const mpfr& x) { return mpfr(cos(x)); };
            const mpfr exchanged =
                std::max(distance_at_an_eighth(s, inner, cosine), distance_at_an_eighth(c, inner, sine));
            const mpfr straight =
                std::max(distance_at_an_eighth(s, inner, sine), distance_at_an_eighth(c, inner, cosine));
            return by_errors(exchanged, straight);
        }};
}

// theta from the four series of theta, omega, sine and cosine, each from its own equation [Fairen1988].
power_series<mpfr> four_equations(const jet<mpfr>& start, int order) {
    power_series<mpfr> theta({start.value});
    power_series<mpfr> omega({start.slope});
    power_series<mpfr> s({sin(start.value)});
    power_series<mpfr> c({cos(start.value)});
    for (int n = 0; n < order; ++n) {
        const mpfr sine = product_coefficient(c, omega, n) / (n + 1);
        const mpfr cosine = -product_coefficient(s, omega, n) / (n + 1);
        theta.push_back(omega[n] / (n + 1));
        omega.push_back(-s[n] / (n + 1));
        s.push_back(sine);
        c.push_back(cosine);
    }
    return theta;
}

// Largest |a_n - b_n| R^n n/8: relative to the size of the coefficients.
mpfr relative_distance(const power_series<mpfr>& a, const power_series<mpfr>& b, const mpfr& radius) {
    mpfr largest(0);
    mpfr power(1);
    for (int n = 1; n <= std::min(a.order(), b.order()); ++n) {
        power *= radius;
        largest = std::max(largest, mpfr(abs(a[n] - b[n]) * power * n / 8));
    }
    return largest;
}

claim four_equations_agree() {
    return {"four_equations_agree",
            "sec:reccurence, text",
            "Four equations, for theta, its derivative, sin theta and cos theta, give the same coefficients.",
            "largest |difference| of a_n, n <= 100, times n/8, from (1, 1/2) and (-3, 4)",
            "",
            "./run coefficients --theta0 -3 --omega0 4 --order 10",
            [] {
                const jet<mpfr> swing{mpfr(1), mpfr(1) / 2};
                const jet<mpfr> turn{mpfr(-3), mpfr(4)};
                const mpfr one(1);  // below both radii
                return by_error(
                    std::max(relative_distance(printed_series(swing, 100, one), four_equations(swing, 100), one),
                             relative_distance(printed_series(turn, 100, one), four_equations(turn, 100), one)));
            }};
}

// y'' = -linear y + cubic y^3, satisfied by cd, sn and omega.
power_series<mpfr> cubic_oscillator(const jet<mpfr>& start, const mpfr& linear, const mpfr& cubic, int order) {
    power_series<mpfr> y({start.value, start.slope});
    auto square = power_series<mpfr>::zero(order);
    for (int n = 0; n + 2 <= order; ++n) {
        square[n] = square_coefficient(y, n);
        y.push_back((product_coefficient(square, y, n) * cubic - y[n] * linear) / (n + 1) / (n + 2));
    }
    return y;
}

// 2 arcsin y from theta' = 2 y'/sqrt(1 - y^2).
power_series<mpfr> twice_arcsine(const power_series<mpfr>& y) {
    auto rest = y * y;
    for (int n = 0; n <= rest.order(); ++n) {
        rest[n] = (n == 0 ? 1 : 0) - rest[n];
    }
    const auto slope = derivative(y) * power(rest, mpfr(mpfr(-1) / 2));
    auto theta = integral(slope, mpfr(asin(y[0]) * 2));
    for (int n = 1; n <= theta.order(); ++n) {
        theta[n] *= 2;
    }
    return theta;
}

claim arcsine_route() {
    return {"arcsine_route",
            "sec:reccurence, text",
            "The series of cd and sn, put into (subcritical) and (supercritical) under the arcsine, give the same "
            "coefficients.",
            "largest |difference| of a_n, n <= 100, times n/8, E = 1.71 from the top, E = 8 from the bottom",
            "",
            "./run coefficients --energy 1.71 --order 10",
            [] {
                const mpfr e = number("1.71");
                const mpfr one(1);  // below both radii
                const auto top = top_of(e);
                // y = k cd(t, k): y'' = -(1 + k^2) y + 2 y^3.
                const auto librating = cubic_oscillator({sqrt(e / 2), mpfr(0)}, 1 + e / 2, mpfr(2), 100);
                // y = sn(2t, 1/2): y'' = -5 y + 2 y^3.
                const auto rotating = cubic_oscillator({mpfr(0), mpfr(2)}, mpfr(5), mpfr(2), 100);
                return by_error(std::max(
                    relative_distance(printed_series(top, 100, one), twice_arcsine(librating), one),
                    relative_distance(printed_series({mpfr(0), mpfr(4)}, 100, one), twice_arcsine(rotating), one)));
            }};
}

// omega is itself a Jacobi function, -2 k k' sd(t, k) below E = 2 and 2 dn(t sqrt(E/2), k) sqrt(E/2) above (from the
// bottom), and satisfies omega'' = (E - 1) omega - omega^3/2.
power_series<mpfr> integrated_omega(const jet<mpfr>& start, const mpfr& energy, int order) {
    const jet<mpfr> omega{start.slope, mpfr(-sin(start.value))};
    return integral(cubic_oscillator(omega, 1 - energy, mpfr(mpfr(-1) / 2), order - 1), start.value);
}

claim arcsine_is_required() {
    return {"arcsine_is_required",
            "sec:reccurence, text",
            "To get theta(t) from the series of the Jacobi functions in (subcritical) and (supercritical), an arcsine "
            "of a series is required.",
            "largest |difference| of a_n, n <= 100, times n/8, from the series of a Jacobi function integrated term by "
            "term, E = 1.71 and 8 from the top",
            "In these two formulas it is. But theta' is a Jacobi function itself, -2 k k' sd(t, k) below E = 2: a_n is "
            "its coefficient n-1 over n, without an arcsine; and rotation from the top cannot be expanded under the "
            "arcsine, for which sn = 1 is a branch point.",
            "./run coefficients --energy 8 --order 10",
            [] {
                mpfr largest(0);
                for (const char* energy : {"1.71", "8"}) {
                    const mpfr e = number(energy);
                    const mpfr one(1);  // below both radii
                    const mpfr distance = relative_distance(printed_series(top_of(e), 100, one),
                                                            integrated_omega(top_of(e), e, 100), one);
                    largest = std::max(largest, distance);
                }
                return by_tests(largest > negligible(), largest < negligible(), largest);
            }};
}

// The number of products in sum_k f_k g_(n-k), n = 0 .. count-1; half of them for a square.
long products(int count, bool square) {
    long sum = 0;
    for (int n = 0; n < count; ++n) {
        sum += square ? n / 2 + 1 : n + 1;
    }
    return sum;
}

claim elliptic_route_costs_more() {
    return {
        "elliptic_route_costs_more",
        "sec:intro, text",
        "To convert the series of Jacobi functions to that of theta takes more arithmetic steps than the recurrences "
        "of the pendulum.",
        "products for a_100 by omega'' = (E-1) omega - omega^3/2 over products by (pendseries), no symmetry used, a "
        "square as half a product",
        "Through the arcsine it does: 1.5 times as many products. Through omega, a Jacobi function, it takes a square "
        "and a product a coefficient instead of two products, with the same coefficients: 0.753 times as many if the "
        "square counts as half a product, exactly as many if it counts as a whole one.",
        "./run coefficients --energy 8 --order 10",
        [] {
            constexpr int order = 100;
            const auto start = top_of(number("1.71"));
            const mpfr one(1);
            const mpfr distance = relative_distance(printed_series(start, order, one),
                                                    integrated_omega(start, number("1.71"), order), one);
            // (pendseries) needs s_n, c_n up to n = N-2, omega its square and its cube up to n = N-3.
            const long printed = 2 * products(order - 2, false);
            const long by_omega = products(order - 2, true) + products(order - 2, false);
            const long of_whole_squares = 2 * products(order - 2, false);
            const mpfr ratio = mpfr(by_omega) / printed;
            const bool costs_no_more = distance < negligible() && of_whole_squares <= printed;
            return by_tests(ratio > 1 || distance > negligible(), costs_no_more, ratio);
        }};
}

// From the bottom: a_n T*^n.
power_series<mpfr> from_bottom(const char* energy, const char* theta0, int order) {
    return printed_series({from_exact<mpfr>(read_exact(theta0)), sqrt(number(energy) * 2)}, order,
                          effective_period_of(energy));
}

claim figure_series_diverges() {
    return {"figure_series_diverges",
            "fig:series",
            "Expanded at the bottom, theta0 = 0 with E = 1.71 and theta0 = 2 pi with E = 2.02, the series diverges "
            "before T*.",
            "the smaller of the terms |a_n| T*^n at n = 999",
            "",
            "./run coefficients --energy 1.71 --at bottom --order 20",
            [] {
                const mpfr swing = abs(from_bottom("1.71", "0", 999)[999]);
                const mpfr turn = abs(from_bottom("2.02", "2pi", 999)[999]);
                const mpfr smaller = std::min(swing, turn);
                return by_test(smaller > 1000, smaller);
            }};
}

claim figure_series_orders() {
    return {"figure_series_orders",
            "fig:series, caption",
            "The sums up to and including the powers N = 10, 100 and 1000 are drawn.",
            "largest |a_N| T*^N at N = 10, 100, 1000, E = 1.71 from the bottom",
            "Motions through the bottom have odd powers only: these sums end with the powers 9, 99 and 999.",
            "./run coefficients --energy 1.71 --at bottom --order 10",
            [] {
                const auto a = from_bottom("1.71", "0", 1000);
                const mpfr even = std::max({mpfr(abs(a[10])), mpfr(abs(a[100])), mpfr(abs(a[1000]))});
                return by_tests(even > negligible(), a[9] != 0 && a[99] != 0 && a[999] != 0, even);
            }};
}

claim runge_kutta_is_the_truth() {
    return {"runge_kutta_is_the_truth",
            "sec:reccurence, footnote 5",
            "Fourth-order Runge-Kutta with step 1e-5 is an accurate numerical solution.",
            "largest error at t = 1 .. 10 with step 1e-5, E = 1.71 from the top: that with step 1/400, 50 digits, "
            "times (400 1e-5)^4, since halving 1/200 gains 2^4 within 5%",
            "",
            "./run trajectory --energy 1.71 --method rk4 --times 0,10 --scalar double",
            [] {
                const auto top = top_of(number("1.71"));
                const auto error = [&](int steps_a_unit) {
                    runge_kutta_march<mpfr> march(top, mpfr(1) / steps_a_unit);
                    flow<mpfr> along(top.value, top.slope);
                    mpfr largest(0);
                    for (int t = 1; t <= 10; ++t) {
                        const mpfr away = march.advance_to(mpfr(t)).value - along.advance_to(mpfr(t)).theta.re;
                        largest = std::max(largest, mpfr(abs(away)));
                    }
                    return largest;
                };
                const mpfr fine = error(400);
                const mpfr order = log(error(200) / fine) / log(mpfr(2));
                const mpfr printed = fine * pow(mpfr(400) / 100000, 4);
                return by_test(abs(order - 4) < mpfr(1) / 20 && printed < epsilon<double>(), printed);
            }};
}

}  // namespace

std::vector<claim> claims_of_series() {
    return {pendulum_recurrence(),
            exponential_recurrence_claim(),
            series_labels(),
            four_equations_agree(),
            arcsine_route(),
            arcsine_is_required(),
            elliptic_route_costs_more(),
            runge_kutta_is_the_truth(),
            figure_series_diverges(),
            figure_series_orders()};
}

}  // namespace libration
