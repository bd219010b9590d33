// Families of the population beyond points and pairs: essential singularities, natural boundaries, symmetric series,
// special functions, many poles, and noise; and the list of all families that the radius is calibrated on.
#pragma once

#include <utility>
#include <vector>

#include "point_families.hpp"

namespace libration::tests {

namespace population {

inline drawn_series essential(dice& d, int n) {
    const mpfr x0 = d.place();
    auto f = d.weight() * power_at(x0, mpfr(-1), n);
    f[0] = 0;
    return {exponential(f), abs(x0)};
}

inline drawn_series partitions(dice& d, int n) {  // prod (1 - x^k)^e, e = -1, -2, 1, 24: a natural boundary
    const int e = d.one_of<int>({-1, -2, 1, 24});
    auto a = polynomial({mpfr(1)}, n);
    for (int k = 1; k <= n; ++k) {
        for (int times = 0; times < (e < 0 ? -e : e); ++times) {
            for (int m = e < 0 ? k : n; e < 0 ? m <= n : m >= k; m += e < 0 ? 1 : -1) {
                a[m] += e < 0 ? a[m - k] : mpfr(-a[m - k]);
            }
        }
    }
    const mpfr x0 = d.place();
    return {rescale(a, mpfr(1 / x0)), abs(x0)};
}

inline drawn_series random_signs(dice& d, int n) {
    auto a = power_series<mpfr>::zero(n);
    for (int k = 0; k <= n; ++k) {
        a[k] = d.sign();
    }
    return {a, mpfr(1)};
}

inline drawn_series lacunary(dice& d, int n) {
    const int p = d.below(2);
    auto a = power_series<mpfr>::zero(n);
    for (int k = 1, at = 1; at <= n; ++k, at = p == 0 ? 2 * at : k * k) {
        a[at] = 1;
    }
    return {a, mpfr(1)};
}

inline drawn_series symmetric(dice& d, int n) {  // x^j h(x^s)
    const int s = 2 + d.below(3);
    const int j = d.below(s);
    drawn_series h = d.below(2) == 0 ? algebraic_times_entire(d, n / s) : pair_times_entire(d, n / s);
    auto a = power_series<mpfr>::zero(n);
    for (int k = 0; j + s * k <= n; ++k) {
        a[j + s * k] = h.a[k];
    }
    for (auto& each : h.nearest) {
        each.at = stride_root(each.at, s);
    }
    return {std::move(a), exp(log(h.radius) / s), std::move(h.nearest)};
}

inline drawn_series nested_roots(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr half = mpfr(1) / 2;
    const auto root = power_at(x0, half, n);
    auto small = d.weight() * root;
    small[0] = 0;
    switch (d.below(3)) {
        case 0: return at_point(exponential(small), x0, half);
        case 1: return at_point(power(polynomial({mpfr(1)}, n) + root, half, mpfr(sqrt(mpfr(2)))), x0, half);
        default: return at_point(polynomial({mpfr(1)}, n) / (polynomial({mpfr(2)}, n) + root), x0, half);
    }
}

inline drawn_series hypergeometric(dice& d, int n) {  // 2F1(a, b; c; x/x0), c - a - b not an integer
    const mpfr x0 = d.place();
    const mpfr a = d.thousandths(101, 1901);
    const mpfr b = d.thousandths(103, 1903);
    const mpfr c = d.thousandths(300, 3000) + mpfr(1) / 3;
    return at_point(series_by_steps(n, mpfr(1),
                                    [&](const mpfr& before, int k) {
                                        return mpfr(before * (a + k - 1) * (b + k - 1) / ((c + k - 1) * k * x0));
                                    }),
                    x0, mpfr(c - a - b));
}

inline drawn_series generalized_hypergeometric(dice& d, int n) {  // 3F2: an analytic part and one with its own exponent
    const mpfr x0 = d.place();
    const mpfr a = d.thousandths(101, 1901);
    const mpfr b = d.thousandths(103, 1903);
    const mpfr e = d.thousandths(107, 1907);
    const mpfr c = d.thousandths(300, 2000) + mpfr(1) / 7;
    const mpfr f = d.thousandths(300, 2000) + mpfr(1) / 11;
    return at_point(series_by_steps(n, mpfr(1),
                                    [&](const mpfr& before, int k) {
                                        return mpfr(before * (a + k - 1) * (b + k - 1) * (e + k - 1) /
                                                    ((c + k - 1) * (f + k - 1) * k * x0));
                                    }),
                    x0, mpfr(c + f - a - b - e));
}

inline drawn_series special_function(dice& d, int n) {
    const mpfr half_pi = pi<mpfr>() / 2;
    const mpfr half = mpfr(1) / 2;
    switch (d.below(8)) {
        case 0: return opposite_points(tangent_series<mpfr>(n), half_pi, {mpfr(-1), mpfr(-1)});
        case 1:
            return opposite_points(secant_series<mpfr>(n) + entire_term(d, half_pi, n), half_pi, {mpfr(-1), mpfr(-1)});
        case 2: return at_pair(bernoulli_series<mpfr>(n), mpfr(4 * half_pi), mpfr(0), mpfr(-1));
        case 3: return at_point(lambert_series<mpfr>(n), mpfr(-exp(mpfr(-1))), half);
        case 4: return at_point(catalan_series<mpfr>(n), mpfr(1) / 4, half);
        case 5: return at_point(parameter_series_of_k<mpfr>(n), mpfr(1), mpfr(0));
        case 6: return at_point(digamma_series<mpfr>(n), mpfr(-1), mpfr(-1));
        default: {
            const auto at = inverse_langevin_singularity<mpfr>();
            return {inverse_langevin_series<mpfr>(n), modulus_of(at), {{at, half}}};
        }
    }
}

inline drawn_series shifted_tangent(dice& d, int n) {  // y' = b^2 + y^2, y(0) = y0: poles (pi/2 - c)/b apart by pi/b
    const mpfr b = d.thousandths(500, 2000);
    const mpfr c = d.thousandths(100, 700);
    auto y = power_series<mpfr>::zero(n);
    y[0] = b * tan(c);
    for (int k = 0; k < n; ++k) {
        y[k + 1] = (square_coefficient(y, k) + (k == 0 ? mpfr(b * b) : mpfr(0))) / (k + 1);
    }
    return at_point(std::move(y), mpfr((pi<mpfr>() / 2 - c) / b), mpfr(-1));
}

inline drawn_series many_poles(dice& d, int n) {
    drawn_series all{power_series<mpfr>::zero(n), mpfr(100)};
    for (int k = 0; k < 8; ++k) {
        const mpfr r = d.thousandths(1000, 2500);
        const mpfr x0 = r * d.sign();
        const mpfr c = cosine(d);
        const auto one = d.below(2) == 0 ? at_point(d.weight() * power_at(x0, mpfr(-1), n), x0, mpfr(-1))
                                         : at_pair(d.weight() * power_of_pair(r, c, mpfr(-1), n), r, c, mpfr(-1));
        all.a = all.a + one.a;
        if (r <= all.radius) {
            all.radius = r;
            all.nearest = one.nearest;
        }
    }
    return all;
}

/// Every coefficient wrong by up to 10^-digits of its size.
inline drawn_series with_noise(dice& d, drawn_series of, int digits) {
    const mpfr size = pow(mpfr(10), -digits);
    for (int k = 0; k <= of.a.order(); ++k) {
        of.a[k] *= 1 + size * d.thousandths(-1000, 1000);
    }
    return of;
}

/// Every coefficient wrong by up to 10^-digits.
inline drawn_series with_floor(dice& d, drawn_series of, int digits) {
    const mpfr size = pow(mpfr(10), -digits);
    for (int k = 0; k <= of.a.order(); ++k) {
        of.a[k] += size * d.thousandths(-1000, 1000);
    }
    return of;
}

inline drawn_series noisy_point(dice& d, int n) { return with_noise(d, algebraic_and_entire(d, n), 4 + d.below(9)); }
inline drawn_series noisy_logarithm(dice& d, int n) {
    return with_noise(d, logarithm_and_entire(d, n), 4 + d.below(9));
}
inline drawn_series noisy_pair(dice& d, int n) { return with_noise(d, pair_times_entire(d, n), 4 + d.below(9)); }
inline drawn_series noisy_poles(dice& d, int n) { return with_noise(d, many_poles(d, n), 4 + d.below(9)); }
inline drawn_series noisy_near_and_far(dice& d, int n) { return with_noise(d, near_and_far(d, n), 4 + d.below(9)); }

inline drawn_series floored_point(dice& d, int n) {
    const mpfr x0 = d.thousandths(1500, 4000) * d.sign();
    const mpfr nu = d.exponent();
    auto whole = at_point(power_at(x0, nu, n) + entire_term(d, x0, n), x0, nu);
    return with_floor(d, std::move(whole), 12 + d.below(5));
}
inline drawn_series floored_pair(dice& d, int n) {
    const mpfr r = d.thousandths(1500, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    return with_floor(d, at_pair(power_of_pair(r, c, nu, n), r, c, nu), 12 + d.below(5));
}

}  // namespace population

/// All families.
inline std::vector<series_family> all_series_families() {
    using namespace population;
    return {{"algebraic point + entire", algebraic_and_entire},
            {"algebraic point * entire", algebraic_times_entire},
            {"logarithm * entire", logarithm_and_entire},
            {"pole + branch point beyond", pole_and_branch_point},
            {"opposite points, sum", opposite_sum},
            {"opposite points, product", opposite_product},
            {"logarithm + opposite power", logarithm_and_opposite_power},
            {"two 0.2 to 1 % apart, sum", close_sum},
            {"two 0.2 to 1 % apart, product", close_product},
            {"poles 0.2 to 1 % apart", close_poles},
            {"near + far", near_and_far},
            {"weak near + strong far", weak_and_strong},
            {"pair + entire", pair_and_entire},
            {"pair * entire", pair_times_entire},
            {"pair of logarithms", pair_of_logarithms},
            {"two pairs", two_pairs},
            {"pair * point on one circle", pair_and_point},
            {"confluent", confluent},
            {"squared logarithm", squared_logarithm},
            {"power * logarithm", power_times_logarithm},
            {"1/logarithm", inverse_logarithm},
            {"essential", essential},
            {"partitions", partitions},
            {"random signs", random_signs},
            {"lacunary", lacunary},
            {"symmetric", symmetric},
            {"nested roots", nested_roots},
            {"2F1", hypergeometric},
            {"3F2", generalized_hypergeometric},
            {"special functions", special_function},
            {"tangent of a shift", shifted_tangent},
            {"many poles", many_poles},
            {"noise: point", noisy_point},
            {"noise: logarithm", noisy_logarithm},
            {"noise: pair", noisy_pair},
            {"noise: poles", noisy_poles},
            {"noise: near + far", noisy_near_and_far},
            {"floor: point", floored_point},
            {"floor: pair", floored_pair}};
}

}  // namespace libration::tests
