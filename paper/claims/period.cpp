// Section V: the period and its resummation.
#include <algorithm>
#include <array>
#include <string_view>

#include "claim.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace series;
using namespace elliptic;
using namespace pendulum;

using namespace judging;

namespace {

modulus<mpfr> modulus_of_square(const mpfr& square) {
    return {sqrt(square), sqrt(1 - square), modulus<mpfr>::source::modulus};
}

// A function of v and 1-v integrated over [0, 1] by the double exponential rule, which tolerates 1/sqrt(1-v) at the
// end: v = 1/(1 + e^(-2s)), s = (pi/2) sinh tau, dv = 2 v (1-v) ds.
template <class F>
mpfr integral_over_unit(const F& f) {
    const int steps_per_unit = 64;
    const int last = 5 * steps_per_unit;
    const mpfr half_turn = pi<mpfr>() / 2;
    mpfr sum(0);
    for (int i = -last; i <= last; ++i) {
        const mpfr tau = mpfr(i) / steps_per_unit;
        const mpfr s = half_turn * sinh(tau);
        const mpfr v = 1 / (1 + exp(mpfr(-2 * s)));
        const mpfr rest = 1 / (1 + exp(mpfr(2 * s)));
        sum += f(v, rest) * v * rest * 2 * half_turn * cosh(tau);
    }
    return sum / steps_per_unit;
}

// The error of (Kold) and (Knew) truncated after k^(2N).
mpfr old_error(const modulus<mpfr>& m, int order) {
    return abs(complete_integral_series(m, order) - complete_integral(m));
}
mpfr new_error(const modulus<mpfr>& m, int order) {
    return abs(complete_integral_resummed(m, order) - complete_integral(m));
}

claim kold_converges() {
    return {
        .name = "Kold_converges",
        .label = "Kold",
        .statement = "(pi/2) sum ((2n)!/n!^2)^2 16^-n k^(2n) is K(k).",
        .number = "error of N = 100 over the first omitted term/k'^2, k^2 = 0.855; K by the arithmetic-geometric mean",
        .correction = "",
        .command = "./run period --energy 1.71 --method series --order 100",
        .measure = [] {
            const auto m = modulus_of_square(mpfr(855) / 1000);
            const mpfr omitted = complete_integral_series(m, 101) - complete_integral_series(m, 100);
            const mpfr ratio = old_error(m, 100) / (omitted / (m.complement * m.complement));
            return by_tests(ratio < 1, false, ratio);
        }};
}

claim kold_domain() {
    return {.name = "Kold_domain",
            .label = "Kold, text",
            .statement = "k^2 < 1 always holds for the pendulum.",
            .number = "largest k^2 over E = 0, 1e-6, 1, 1.71, 2 -+ 1e-6, 4, 1e6, and 2 by its formula E/2",
            .correction =
                "For every motion with a period. At E = 2, the separatrix, which the paper counts among the motions, "
                "k^2 = 1; there is no period to compute.",
            .command = "./run period --gap 1e-6 --method series --order 10",
            .measure = [] {
                bool periodic = true;
                for (const std::string_view energy : {"0", "1e-6", "1", "1.71", "1.999999", "2.000001", "4", "1e6"}) {
                    const mpfr k = energy_level_of<mpfr>(of_energy(energy)).modulus.k;
                    periodic = periodic && k * k < 1;
                }
                const mpfr largest = energies<mpfr>(of_energy("2")).energy / 2;
                return by_tests(largest < 1, periodic, largest);
            }};
}

claim kold_towards_separatrix() {
    return {.name = "Kold_towards_separatrix",
            .label = "fig:perioderror, text",
            .statement = "The error of T* by (Kold) increases as E tends to 2, from below and from above.",
            .number = "smallest ratio of successive errors, N = 0, 5, 50, over twelve energies towards 2 on each side",
            .correction = "",
            .command = "./run period --energy 1.9 --method series --order 5",
            .measure = [] {
                mpfr smallest(1000);
                const std::array<std::string_view, 6> gaps{"1", "0.5", "0.1", "1e-2", "1e-6", "1e-12"};
                for (const int order : {0, 5, 50}) {
                    for (const int side : {1, -1}) {
                        mpfr before(0);
                        for (const std::string_view gap : gaps) {
                            const rational away = read_exact(gap).coefficient * side;
                            const auto o = energy_level_of<mpfr>(motion::of_energy(rational(2 - away)));
                            const mpfr now = abs(effective_period_series(o, order) - effective_period(o));
                            smallest = before == 0 ? smallest : std::min(smallest, mpfr(now / before));
                            before = now;
                        }
                    }
                }
                return by_tests(smallest > 1, false, smallest);
            }};
}

claim kold_hundred_terms() {
    return {.name = "Kold_hundred_terms",
            .label = "fig:period, text",
            .statement = "Near E = 2 one needs more than 100 terms of (Kold) for an accurate solution.",
            .number = "smallest N with an error of T* below 1e-4, from the bottom with omega0 = 1.9999",
            .correction = "",
            .command = "./run period --theta0 0 --omega0 1.9999 --method series --order 65148",
            .measure = [] {
                const auto o = energy_level_of<mpfr>(motion::of_state(exact{}, read_exact("1.9999")));
                const mpfr parameter = o.modulus.k * o.modulus.k;
                const mpfr wanted = mpfr(1) / 10000;
                mpfr term = pi<mpfr>() / 2;
                mpfr rest = complete_integral(o.modulus) - term;
                int order = 0;
                while (rest > wanted) {
                    ++order;
                    const mpfr ratio = mpfr(2 * order - 1) / (2 * order);
                    term *= ratio * ratio * parameter;
                    rest -= term;
                }
                return by_tests(order > 100, false, mpfr(order));
            }};
}

claim k2_equals_k() {
    return {.name = "K2_equals_K",
            .label = "K2",
            .statement = "The integral over v from 0 to 1 is K(k).",
            .number = "decimal digits to which quadrature and arithmetic-geometric mean agree, k^2 = 0.855, 50 carried",
            .correction = "",
            .command = "./run claims K2_equals_K",
            .measure = [] {
                const auto m = modulus_of_square(mpfr(855) / 1000);
                const mpfr parameter = m.k * m.k;
                const mpfr value = integral_over_unit([&](const mpfr& v, const mpfr& rest) {
                    return mpfr(1 / sqrt(rest * (1 + v) * (1 - parameter * v * v)));
                });
                const mpfr agreed = -log10(mpfr(abs(value - complete_integral(m)) + epsilon<mpfr>()));
                return by_tests(agreed > 40, false, agreed);
            }};
}

claim split_of_k() {
    return {.name = "split_of_K",
            .label = "sec:period, I_1 and I_2",
            .statement =
                "K = I_1 + I_2, with I_1 the integral of (sqrt(1-k^2v^2) - sqrt(1-v^2))/((1-k^2v^2) sqrt(1-v^2)) and "
                "I_2 that of 1/(1-k^2v^2).",
            .number = "decimal digits to which both sides agree, integrals by quadrature, k^2 = 0.855, 50 carried",
            .correction = "",
            .command = "./run claims split_of_K",
            .measure = [] {
                const auto m = modulus_of_square(mpfr(855) / 1000);
                const mpfr parameter = m.k * m.k;
                const mpfr sum = integral_over_unit([&](const mpfr& v, const mpfr& rest) {
                    const mpfr inner = 1 - parameter * v * v;
                    const mpfr outer = sqrt(rest * (1 + v));
                    const mpfr first = (sqrt(inner) - outer) / (inner * outer);
                    return mpfr(first + 1 / inner);
                });
                const mpfr agreed = -log10(mpfr(abs(sum - complete_integral(m)) + epsilon<mpfr>()));
                return by_tests(agreed > 40, false, agreed);
            }};
}

claim i2_closed_form() {
    return {.name = "I2_closed_form",
            .label = "zero",
            .statement = "I_2 = ln((1+k)/(1-k))/(2k) = artanh(k)/k = sum k^(2n)/(2n+1).",
            .number = "decimal digits to which quadrature and series agree with the logarithm, k^2 = 1/2, 50 carried",
            .correction = "",
            .command = "./run claims I2_closed_form",
            .measure = [] {
                const auto m = modulus_of_square(mpfr(1) / 2);
                const mpfr parameter = m.k * m.k;
                const mpfr closed = log((1 + m.k) / (1 - m.k)) / (2 * m.k);
                const mpfr quadrature =
                    integral_over_unit([&](const mpfr& v, const mpfr&) { return mpfr(1 / (1 - parameter * v * v)); });
                mpfr series(0);
                mpfr power(1);
                for (int n = 0; n <= 180; ++n) {
                    series += power / (2 * n + 1);
                    power *= parameter;
                }
                const mpfr off = std::max(mpfr(abs(quadrature - closed)), mpfr(abs(series - closed)));
                const mpfr agreed = -log10(mpfr(off + epsilon<mpfr>()));
                return by_tests(agreed > 40, false, agreed);
            }};
}

claim knew_converges() {
    return {.name = "Knew_converges",
            .label = "Knew",
            .statement = "The sum of the bracketed coefficients times k^(2n), and artanh(k)/k, is K(k).",
            .number = "error of N = 100 over k'^-2 k^202/(8 101^2), k^2 = 0.855; K by the arithmetic-geometric mean",
            .correction = "",
            .command = "./run period --energy 1.71 --method resummed --order 100",
            .measure = [] {
                const auto m = modulus_of_square(mpfr(855) / 1000);
                const mpfr expected = pow(m.k, 202) / (m.complement * m.complement * 8 * 101 * 101);
                const mpfr ratio = new_error(m, 100) / expected;
                return by_tests(ratio < mpfr(11) / 10, false, ratio);
            }};
}

claim knew_better() {
    return {
        .name = "Knew_better",
        .label = "Knew, text",
        .statement = "The convergence of (Knew) is significantly improved, compared with (Kold).",
        .number = "smallest error of (Kold) over that of (Knew), N = 0 ... 50, k^2 = 1e-6 ... 1 - 1e-12",
        .correction = "",
        .command = "./run period --energy 1e-3 --method resummed --order 0",
        .measure = [] {
            // Smallest as k -> 0 at N = 0: there it is (pi/8)/(pi/8 - 1/3) = 6.62.
            const precision_scope enough(400);
            mpfr smallest(1000);
            for (const std::string_view square : {"1e-6", "1e-3", "0.1", "0.5", "0.855", "0.99", "0.999999999999"}) {
                const auto m = modulus_of_square(from_exact<mpfr>(read_exact(square)));
                for (int order = 0; order <= 50; order = order * 2 + 1) {
                    smallest = std::min(smallest, mpfr(old_error(m, order) / new_error(m, order)));
                }
            }
            return by_tests(smallest > 1, false, smallest);
        }};
}

claim knew_rapid() {
    return {.name = "Knew_rapid",
            .label = "sec:convergence, text; Knew",
            .statement = "(Knew) is a rapidly converging series for the period at every energy.",
            .number = "error of N = 800 over that of N = 400 by (Knew), 2 - E = 1e-12",
            .correction =
                "Its terms fall like k^(2n)/(8 n^2), at the same geometric rate k^2 as those of (Kold), which tends "
                "to 1: next to E = 2 the error is about 1/(8N), and 1e-10 takes a thousand million terms. At 2 - E "
                "= 1e-12, N = 10 leaves 0.0114, N = 100 leaves 0.00124; the arithmetic-geometric mean has 50 "
                "digits after 10 steps.",
            .command = "./run period --gap 1e-12 --method resummed --order 100",
            .measure = [] {
                const auto o = energy_level_of<mpfr>(of_gap("1e-12"));
                const mpfr ratio = new_error(o.modulus, 800) / new_error(o.modulus, 400);
                // Rapid would be a fixed factor per given number of further terms; 1/(8N) only halves.
                return by_tests(ratio < mpfr(1) / 1000, abs(ratio * 2 - 1) < mpfr(1) / 100, ratio);
            }};
}

claim knew_limit() {
    return {.name = "Knew_limit",
            .label = "Knew, text",
            .statement = "The singular behaviour that makes (Kold) slow is summed exactly by the logarithm.",
            .number = "(K - artanh(k)/k - ln 2)/(k'^2 ln k') at k' = 1e-15",
            .correction =
                "Only its leading part, ln(1/k'). What is left is ln 2 + (1/4) k'^2 ln k' + ...: finite, but with a "
                "branch point at k = 1 still, hence the brackets 1/(8 n^2) and their sum ln 2, which N terms miss "
                "by 1/(8N): at N = 0 by 0.122, at N = 10 by 0.0114.",
            .command = "./run claims Knew_limit",
            .measure = [] {
                const precision_scope enough(90);
                const mpfr complement = pow(mpfr(10), -15);
                const auto m = modulus<mpfr>::from_complement(complement);
                const mpfr rest = complete_integral(m) - artanh_over_modulus(m) - log(mpfr(2));
                const mpfr coefficient = rest / (complement * complement * log(complement));
                // An analytic remainder would be c k'^2: no logarithm, and this quotient would tend to 0 like 1/ln k'.
                const auto next = modulus<mpfr>::from_complement(mpfr(complement * complement));
                const mpfr deeper = (complete_integral(next) - artanh_over_modulus(next) - log(mpfr(2))) /
                                    (pow(complement, 4) * log(complement) * 2);
                const mpfr quarter = mpfr(1) / 4;
                const mpfr hundredth = mpfr(1) / 100;
                return by_tests(abs(deeper) < hundredth, abs(deeper - quarter) < hundredth, coefficient);
            }};
}

claim knew_tail() {
    return {.name = "Knew_tail",
            .label = "Knew",
            .statement = "(Knew) needs k^2 < 1.",
            .number = "8 N (ln 2 - sum of the brackets to N), N = 1000",
            .correction = "",
            .command = "./run claims Knew_tail",
            .measure = [] {
                // The sum itself converges at k = 1, to ln 2; what is infinite there is artanh(k)/k alone.
                const int order = 1000;
                mpfr binomial = pi<mpfr>() / 2;
                mpfr sum = binomial - 1;
                for (int n = 1; n <= order; ++n) {
                    const mpfr ratio = mpfr(2 * n - 1) / (2 * n);
                    binomial *= ratio * ratio;
                    sum += binomial - mpfr(1) / (2 * n + 1);
                }
                const mpfr tail = (log(mpfr(2)) - sum) * 8 * order;
                const auto steep = modulus<mpfr>::from_complement(pow(mpfr(10), -40));
                return by_tests(abs(tail - 1) < mpfr(1) / 100 && artanh_over_modulus(steep) > 90, false, tail);
            }};
}

claim figure_period() {
    return {.name = "figure_period",
            .label = "fig:period",
            .statement = "Near E = 2 ten terms of (Knew) give the period better than a hundred of (Kold).",
            .number = "smaller error ratio of T*, (Kold) N = 100 over (Knew) N = 10, omega0 = 1.9999 and 2.0001",
            .correction = "",
            .command = "./run period --theta0 0 --omega0 2.0001 --method resummed --order 10",
            .measure = [] {
                mpfr smallest(1000);
                for (const std::string_view speed : {"1.9999", "2.0001"}) {
                    const auto o = energy_level_of<mpfr>(motion::of_state(exact{}, read_exact(speed)));
                    smallest = std::min(smallest, mpfr(old_error(o.modulus, 100) / new_error(o.modulus, 10)));
                }
                return by_tests(smallest > 1, false, smallest);
            }};
}

claim figure_period_drift() {
    return {.name = "figure_period_drift",
            .label = "fig:period",
            .statement = "A solution with the period by (Knew), N = 10, is accurate near E = 2.",
            .number = "error of theta at T + 9 T*/10 with T* by (Knew), N = 10, omega0 = 1.9999",
            .correction =
                "For a fixed number of periods only: T* is 0.0113 short, each period shifts the extended solution by "
                "four times that, and the angle by up to 2 for each unit of time. After 100 periods the shift is "
                "4.5, three quarters of T*.",
            .command = "./run period --theta0 0 --omega0 1.9999 --method resummed --order 10",
            .measure = [] {
                const motion m = motion::of_state(exact{}, read_exact("1.9999"));
                const sampled_arc arc(m);
                const mpfr shift = new_error(arc.of().modulus, 10) * 4;
                const auto error_after = [&](int periods) {
                    const mpfr away = shift * periods / arc.period();
                    const mpfr fast = mpfr(9) / 10;
                    return mpfr(abs(arc.exact(mpfr(fast - away)).value - arc.exact(fast).value));
                };
                const mpfr once = error_after(1);
                return by_tests(error_after(100) < mpfr(1) / 10, once < mpfr(1) / 10, once);
            }};
}

claim period_analyticity() {
    return {.name = "period_analyticity",
            .label = "sec:convergence, text",
            .statement = "With the series for the period the extended solution stays analytic in time.",
            .number = "jump of theta'' at t = T* in the extension of the resummation, E = 1.71, N = 10",
            .correction =
                "In the limit N -> infinity. A truncation is a polynomial on each quarter, joined at multiples of T* "
                "with equal value and slope but with theta'' of opposite sign, which is 0 there for theta alone: "
                "a jump 2 |theta_N''(T*)| at each passage of the bottom, at E = 1.71 and N = 0 1.44.",
            .command = "./run claims period_analyticity",
            .measure = [] {
                const sampled_arc arc(of_energy("1.71"));
                // After the bottom the extension is -theta(2T* - t): its second derivative there has the opposite sign.
                const mpfr inner = evaluate(arc.resummed(10).inner(), mpfr(1)).value;
                const mpfr jump = abs(inner) * 4 / (arc.period() * arc.period());
                const mpfr later = abs(evaluate(arc.resummed(80).inner(), mpfr(1)).value);
                return by_tests(jump < epsilon<mpfr>() * 1000, later < abs(inner) / 100, jump);
            }};
}

claim period_grows() {
    return {.name = "period_grows",
            .label = "Kold, text",
            .statement = "As E tends to 2 the period becomes infinite.",
            .number = "T* - ln(32/|2-E|)/2 at 2 - E = 1e-20",
            .correction = "",
            .command = "./run period --gap 1e-20",
            .measure = [] {
                const mpfr gap = pow(mpfr(10), -20);
                const mpfr rest = effective_period(energy_level_of<mpfr>(of_gap("1e-20"))) - log(32 / gap) / 2;
                const mpfr further = effective_period(energy_level_of<mpfr>(of_gap("1e-40")));
                return by_tests(abs(rest) < mpfr(1) / 1000 && further > 45, false, rest);
            }};
}

}  // namespace

std::vector<claim> claims_of_period() {
    return {kold_converges(),    kold_domain(),        kold_towards_separatrix(),
            period_grows(),      kold_hundred_terms(), k2_equals_k(),
            split_of_k(),        i2_closed_form(),     knew_converges(),
            knew_better(),       knew_rapid(),         knew_limit(),
            knew_tail(),         figure_period(),      figure_period_drift(),
            period_analyticity()};
}

}  // namespace libration
