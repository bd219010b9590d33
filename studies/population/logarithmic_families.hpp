// Families with logarithms upon a power: (1 - x/x0)^nu log(1 - x/x0)^k and what is built of them. The local exponent of
// their coefficients approaches nu as slowly as 1/log n. `logarithmic_families` are calibrated on, the others are held
// out: they test the calibration.
#pragma once

#include <utility>
#include <vector>

#include "point_families.hpp"

namespace libration::tests {

namespace population {

/// a^k.
inline power_series<mpfr> whole_power(const power_series<mpfr>& a, int k) {
    auto product = polynomial({mpfr(1)}, a.order());
    for (int i = 0; i < k; ++i) {
        product = product * a;
    }
    return product;
}

/// log(1 - 2 c x/r + x^2/r^2).
inline power_series<mpfr> logarithm_of_pair(const mpfr& r, const mpfr& c, int order) {
    return rescale(quadratic_logarithm_series(c, order), mpfr(1 / r));
}

inline drawn_series power_of_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    return at_point(whole_power(logarithm_at(x0, n), 2 + d.below(3)), x0, mpfr(0));
}

inline drawn_series power_of_inverse_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    return at_point(polynomial({mpfr(1)}, n) / whole_power(shifted_logarithm(x0, n), 1 + d.below(2)), x0, mpfr(0));
}

inline drawn_series power_times_powers_of_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    return at_point(power_at(x0, nu, n) * whole_power(logarithm_at(x0, n), 1 + d.below(3)), x0, nu);
}

inline drawn_series power_over_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    return at_point(power_at(x0, nu, n) / shifted_logarithm(x0, n), x0, nu);
}

inline drawn_series pole_times_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu(-1 - d.below(2));
    return at_point(power_at(x0, nu, n) * logarithm_at(x0, n) * entire_factor(d, x0, n), x0, nu);
}

inline drawn_series pair_of_powers_of_logarithms(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    return at_pair(whole_power(logarithm_of_pair(r, c, n), 2 + d.below(2)), r, c, mpfr(0));
}

inline drawn_series pair_times_logarithms(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    return at_pair(power_of_pair(r, c, nu, n) * logarithm_of_pair(r, c, n), r, c, nu);
}

/// log(1 - log(1 - x/x0)): a_n ~ 1/(n log n).
inline drawn_series logarithm_of_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const auto one = polynomial({mpfr(1)}, n);
    const auto inner = one - logarithm_at(x0, n);
    // (log g)' = g'/g.
    auto slope = power_series<mpfr>::zero(n);
    for (int k = 0; k < n; ++k) {
        slope[k] = inner[k + 1] * (k + 1);
    }
    slope = slope / inner;
    auto a = power_series<mpfr>::zero(n);
    for (int k = 1; k <= n; ++k) {
        a[k] = slope[k - 1] / k;
    }
    return at_point(std::move(a), x0, mpfr(0));
}

/// Li_s(x/x0) = sum x^n/(x0^n n^s): (1 - x/x0)^(s-1) log(1 - x/x0).
inline drawn_series polylogarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const int s = 2 + d.below(2);
    auto a = power_series<mpfr>::zero(n);
    for (int k = 1; k <= n; ++k) {
        a[k] = mpfr(1) / pow(mpfr(k), s);
    }
    return at_point(rescale(a, mpfr(1 / x0)) + entire_term(d, x0, n), x0, mpfr(s - 1));
}

/// K(m)^2, m = x/x0: log^2 and log, each with its own factor.
inline drawn_series square_of_elliptic_integral(dice& d, int n) {
    const mpfr x0 = d.place();
    const auto k = rescale(parameter_series_of_k<mpfr>(n), mpfr(1 / x0));
    return at_point(k * k, x0, mpfr(0));
}

inline drawn_series exponential_of_root_times_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    auto inside = power_at(x0, mpfr(1) / 2, n) * logarithm_at(x0, n);
    return at_point(exponential(inside), x0, mpfr(1) / 2);
}

inline drawn_series logarithm_and_opposite_square(dice& d, int n) {
    const mpfr x0 = d.place();
    const auto l = logarithm_at(mpfr(-x0), n);
    return opposite_points(power_at(x0, mpfr(-1) / 2, n) + d.weight() * l * l, x0, {mpfr(-1) / 2, mpfr(0)});
}

inline drawn_series pair_over_logarithms(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    const auto l = polynomial({mpfr(3)}, n) - logarithm_of_pair(r, c, n);
    return at_pair(power_of_pair(r, c, nu, n) / l, r, c, nu);
}

}  // namespace population

/// Families with logarithms that uncertainties are calibrated on.
inline std::vector<series_family> logarithmic_families() {
    using namespace population;
    return {{"logarithm^k", power_of_logarithm},
            {"1/logarithm^k", power_of_inverse_logarithm},
            {"power * logarithm^k", power_times_powers_of_logarithm},
            {"power/logarithm", power_over_logarithm},
            {"pole * logarithm", pole_times_logarithm},
            {"pair of logarithms^k", pair_of_powers_of_logarithms},
            {"pair * logarithms", pair_times_logarithms}};
}

/// Families with logarithms that no uncertainty was calibrated on.
inline std::vector<series_family> held_out_logarithmic_families() {
    using namespace population;
    return {{"log(1 - log)", logarithm_of_logarithm},
            {"polylogarithm", polylogarithm},
            {"K(m)^2", square_of_elliptic_integral},
            {"exp(root * logarithm)", exponential_of_root_times_logarithm},
            {"root + opposite logarithm^2", logarithm_and_opposite_square},
            {"pair/logarithms", pair_over_logarithms}};
}

}  // namespace libration::tests
