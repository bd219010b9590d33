// Section IV: the resummation of the series, its formulas and the conditions that they satisfy. Its errors are in
// resummation_errors.cpp, its form in the appendix in appendix.cpp.
#include <cstddef>
#include <utility>
#include <vector>

#include "claim.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace series;

using namespace judging;

namespace {

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
                const sampled_arc arc(of_energy("1.71"));
                const mpfr speed = arc.exact(mpfr(1)).slope / arc.period();
                const mpfr ratio = speed / arc.fastest();
                const mpfr resolution = epsilon<mpfr>() * 100;
                return by_tests(abs(ratio - 1) < resolution, abs(ratio + 1) < resolution, ratio);
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
                    const sampled_arc arc(of_energy("2.02", direction));
                    ratio = arc.exact(mpfr(1)).slope / arc.period() / arc.fastest();
                    both = both && abs(ratio - direction) < epsilon<mpfr>() * 100;
                }
                return by_tests(both, false, ratio);
            }};
}

claim omegab_rate() {
    return {
        .name = "omegab_rate",
        .label = "resummation, omegab",
        .statement = "With omega* of (omegab) the resummation of a libration converges at the series' geometric rate.",
        .number = "norm of the error with omega* = +sqrt(2E) over 2 sqrt(2E) T*/(e N), E = 1.71, N = 100",
        .correction =
            "With the + as printed the error falls only like 2 sqrt(2E) T*/(e N); with omega* = -sqrt(2E) it stays "
            "below the bound A2, which falls like (T*/R)^N. At E = 1.71 and N = 0 the norms are 2.33 and 0.110.",
        .command = "./run claims omegab_rate",
        .measure = [] {
            const int order = 100;
            const sampled_arc arc(of_energy("1.71"));
            const mpfr bound = arc.bound(order);
            const mpfr printed = arc.error_norm(arc.resummed(order, mpfr(0), arc.fastest()));
            const mpfr corrected = arc.error_norm(arc.resummed(order, mpfr(0), mpfr(-arc.fastest())));
            const mpfr slow = arc.fastest() * arc.period() * 2 / (exp(mpfr(1)) * order);
            return by_tests(printed < bound, corrected < bound, printed / slow);
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
                const sampled_arc arc(of_energy("2.02"));
                const mpfr bound = arc.bound(order);
                const mpfr printed = arc.error_norm(arc.resummed(order, mpfr(0), arc.fastest()));
                const mpfr corrected = arc.error_norm(arc.resummed(order, mpfr(pi<mpfr>() * 2), arc.fastest()));
                return by_tests(printed < bound, corrected < bound, printed);
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
                const sampled_arc arc(of_energy("2.02", -1));
                const mpfr ratio =
                    arc.error_norm(arc.resummed(order, mpfr(0), mpfr(-arc.fastest()))) / arc.bound(order);
                return by_tests(ratio < 1, false, ratio);
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
                const sampled_arc arc(of_energy("2.02"));
                // The sum of all b_n T*^n is theta(T*) minus the line there; that of n b_n T*^n, its slope.
                const jet<mpfr> bottom = arc.exact(mpfr(1));
                const mpfr slope = bottom.slope - arc.fastest() * arc.period();
                const bool flat = abs(slope) < epsilon<mpfr>() * 100;
                const mpfr rest = bottom.value - pi<mpfr>() * 2;
                return by_tests(flat && abs(bottom.value) < epsilon<mpfr>() * 100,
                                flat && abs(rest) < epsilon<mpfr>() * 100, bottom.value);
            }};
}

// The formula of (approxcoeffs) exactly as printed, in the unscaled variable.
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
                const mpfr period = sampled_arc(of_energy("1.71")).period();
                const mpfr t = period / 2;
                mpfr sum(0);
                for (int n = 200; n >= 0; --n) {
                    sum = sum * t + pow(mpfr(1 / period), n + 2) * (n + 1);
                }
                const mpfr product = sum * (t - period) * (t - period);
                return by_tests(abs(product - 1) < epsilon<mpfr>() * 1000, false, product);
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
                const sampled_arc arc(of_energy("1.71"));
                const mpfr speed = -arc.fastest();
                auto b = rescale(arc.series(order), mpfr(1 / arc.period())).coefficients();
                b[0] += arc.period() * speed;
                b[1] -= speed;
                auto ahat = ahat_by_the_formula(b, arc.period());
                const mpfr place = mpfr(9) / 10;
                const mpfr value = printed_sum(std::move(ahat), mpfr(arc.period() * place), arc.period(), speed);
                const mpfr ratio = abs(value - arc.exact(place).value) / arc.bound(order);
                return by_tests(ratio < 1, false, ratio);
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
                const sampled_arc arc(of_energy("1.71"));
                const auto printed = arc.resummed(order, mpfr(0), arc.fastest()).inner();
                const auto corrected = arc.resummed(order).inner();
                const mpfr scale = arc.fastest() * arc.period() * 2;
                // |ahat_n T*^(n+2)| decreases like (T*/R)^n if the radius is R; 100 is a margin for the constant.
                const mpfr allowed = pow(arc.rho(), order) * 100;
                return by_tests(abs(printed[order]) < allowed, abs(corrected[order]) < allowed, printed[order] / scale);
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
                const sampled_arc arc(of_energy("1.71"));
                // At -T* the monomial t^(N+1+j) leaves 2j - 1 + (-1)^j times itself: the rate is unchanged.
                const mpfr there(-1);
                const mpfr at_eighty = arc.error_at(arc.resummed(80), there);
                const mpfr at_forty = arc.error_at(arc.resummed(40), there);
                const mpfr rate = pow(arc.rho(), 40);
                return by_tests(at_eighty < at_forty * rate * 10, false, at_eighty);
            }};
}

// The exponent p of an error that behaves like distance^p.
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
                const sampled_arc arc(of_energy("1.71"));
                const auto approximant = arc.resummed(order);
                const mpfr tiny = mpfr(1) / 1000;
                const mpfr power =
                    order_of_contact(arc.error_at(approximant, mpfr(tiny / 10)), arc.error_at(approximant, tiny));
                return by_tests(abs(power - (order + 1)) < mpfr(1) / 100, false, power);
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
                const sampled_arc arc(of_energy("1.71"));
                const auto approximant = arc.resummed(order);
                const mpfr tiny = mpfr(1) / 10000;
                const mpfr power = order_of_contact(arc.error_at(approximant, mpfr(1 - tiny / 10)),
                                                    arc.error_at(approximant, mpfr(1 - tiny)));
                const bool series_misses = arc.error_at(arc.cut(order), mpfr(1)) > mpfr(1) / 1000;
                return by_tests(abs(power - 2) < mpfr(1) / 100 && series_misses, false, power);
            }};
}

// theta_N''(T*) = 2 sum ahat_n T*^n.
mpfr curvature_at_bottom(const sampled_arc& arc, int order) {
    return evaluate(arc.resummed(order).inner(), mpfr(1)).value * 2 / (arc.period() * arc.period());
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
                const sampled_arc arc(of_energy("1.71"));
                const int order = 10;
                const jet<mpfr> end = arc.resummed(order)(mpfr(1));
                const jet<mpfr> bottom = arc.exact(mpfr(1));
                const mpfr resolution = epsilon<mpfr>() * 10000;  // sums of 10 terms of size 1
                const bool tangent =
                    abs(end.value - bottom.value) < resolution && abs(end.slope - bottom.slope) < resolution;
                const mpfr curvature = curvature_at_bottom(arc, order);
                return by_tests(tangent && abs(curvature) < resolution, tangent, curvature);
            }};
}

}  // namespace

std::vector<claim> claims_of_resummation() {
    return {omegab_libration(),      omegab_rotation(),   omegab_rate(),      resummation_counterclockwise(),
            resummation_clockwise(), b_constants(),       square_expansion(), approxcoeffs(),
            exact_resummation(),     resummation_range(), enforced_at_top(),  enforced_at_bottom(),
            second_derivative()};
}

}  // namespace libration
