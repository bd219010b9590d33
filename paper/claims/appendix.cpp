// The appendix: the resummation in powers of t, and the saving that it brings.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "claim.hpp"
#include "libration/pendulum/resummation.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace series;

using namespace judging;

namespace {

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

// sigma_N and sigma_N' at t as required by (efficient), and as printed, sum a_n t^N.
jet<mpfr> sigma_of(const std::vector<mpfr>& a, const mpfr& t) {
    const auto at = evaluate(power_series<mpfr>(a), t);
    return {at.value, at.slope};
}
jet<mpfr> sigma_as_printed(const std::vector<mpfr>& a, const mpfr& t) {
    const int order = static_cast<int>(a.size()) - 1;
    const mpfr sum = evaluate(power_series<mpfr>(a), mpfr(1)).value;
    return {sum * pow(t, order), sum * pow(t, order - 1) * order};
}

std::vector<mpfr> unscaled(const sampled_arc& arc, int order) {
    return rescale(arc.series(order), mpfr(1 / arc.period())).coefficients();
}

// The norm of theta_N - theta with theta_N in powers of t.
mpfr norm_of(const sampled_arc& arc, const appendix_form& form) {
    const truncated_series<mpfr> scaled(rescale(power_series<mpfr>(form.coefficients), arc.period()), mpfr(1));
    return arc.error_norm(scaled);
}

claim appendix_sigma() {
    return {.name = "appendix_sigma",
            .label = "efficient",
            .statement = "sigma_N(t) is the sum of a_n t^N.",
            .number = "norm of the error of theta_10 with alpha and beta from this sum, E = 1.71, omega* = -sqrt(2E)",
            .correction =
                "sigma_N(t) = sum of a_n t^n (a misprint: N for n). With it the norm is below the bound A2. Printed "
                "and meant sums are the same only at N = 0; at E = 1.71 and N = 1 they give at T* 5.68 and 2.36.",
            .command = "./run claims appendix_sigma",
            .measure = [] {
                const int order = 10;
                const sampled_arc arc(of_energy("1.71"));
                const auto a = unscaled(arc, order);
                const mpfr& t = arc.period();
                const mpfr speed = -arc.fastest();
                const mpfr printed = norm_of(arc, {a, t, speed, sigma_as_printed(a, t)});
                const mpfr corrected = norm_of(arc, {a, t, speed, sigma_of(a, t)});
                const mpfr bound = arc.bound(order);
                return by_tests(printed < bound, corrected < bound, printed);
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
            const sampled_arc arc(of_energy("2.02"));
            const auto a = unscaled(arc, order);
            const mpfr& t = arc.period();
            jet<mpfr> sigma = sigma_of(a, t);
            const mpfr printed = norm_of(arc, {a, t, arc.fastest(), sigma});
            sigma.value -= pi<mpfr>() * 2;
            const mpfr corrected = norm_of(arc, {a, t, arc.fastest(), sigma});
            const mpfr bound = arc.bound(order);
            return by_tests(printed < bound, corrected < bound, printed);
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
                const sampled_arc arc(of_energy("1.71"));
                const auto a = arc.series(order);
                // In x = t/T*: A and B with (N+1) A + (N+2) B = slope, (N+1) N A + (N+2)(N+1) B = curvature.
                mpfr slope = -arc.fastest() * arc.period();
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
                const mpfr printed = arc.resummed(order)(mpfr(1)).value;
                return by_tests(abs(end) < epsilon<mpfr>() * 10000, abs(printed) < epsilon<mpfr>() * 10000, end);
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
                const sampled_arc arc(of_energy("1.71"));
                const auto a = unscaled(arc, order);
                const mpfr& t = arc.period();
                const appendix_form form(a, t, mpfr(-arc.fastest()), sigma_of(a, t));
                const truncated_series<mpfr> corrected(rescale(power_series<mpfr>(form.coefficients), t), mpfr(1));
                const auto factored = arc.resummed(order);
                mpfr largest = epsilon<mpfr>();
                for (int i = 0; i <= 20; ++i) {
                    const mpfr x = mpfr(i) / 20;
                    largest = std::max(largest, mpfr(abs(corrected(x).value - factored(x).value)));
                }
                const mpfr agreed = -log10(largest);
                return by_tests(agreed > 45, false, agreed);
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
            const sampled_arc arc(of_energy("1.71"));
            const std::vector<mpfr> end{mpfr(0), mpfr(-arc.fastest() * arc.period())};
            const auto series = arc.series(order);
            const auto sums = inner_series(series, end);
            const auto product = inner_series_by_convolution(series, end);
            mpfr largest = epsilon<mpfr>();
            for (int n = 0; n <= order; ++n) {
                largest = std::max(largest, mpfr(abs(sums[n] - product[n])));
            }
            const mpfr agreed = -log10(largest);
            return by_tests(agreed<40, agreed> 40, agreed);
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
                return by_tests(share > mpfr(1) / 4, false, share);
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
                const sampled_arc arc(of_gap("1e-10"));
                const mpfr largest = mpfr(std::numeric_limits<double>::max());
                int order = 0;
                for (mpfr power = arc.period(); power <= largest; power *= arc.period()) {
                    ++order;
                }
                const mpfr error = arc.error_at(arc.resummed(order), mpfr(mpfr(99) / 100));
                const auto scaled = arc.series(400);
                mpfr widest(0);
                for (int n = 0; n <= 400; ++n) {
                    widest = std::max(widest, mpfr(abs(scaled[n])));
                }
                return by_tests(error < epsilon<double>(), widest < 100, error);
            }};
}

}  // namespace

std::vector<claim> claims_of_appendix() {
    return {appendix_sigma(),          appendix_alpha_beta(), appendix_conditions(), appendix_same_polynomial(),
            appendix_second_product(), appendix_saving(),     appendix_range()};
}

}  // namespace libration
