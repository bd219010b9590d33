// Families of the population with few singularities: single, double and opposite points and pairs, algebraic,
// logarithmic and confluent ones.
#pragma once

#include <vector>

#include "radius_population.hpp"

namespace libration::tests {

namespace population {

inline drawn_series algebraic_and_entire(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    return at_point(d.weight() * power_at(x0, nu, n) + entire_term(d, x0, n), x0, nu);
}

inline drawn_series algebraic_times_entire(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    return at_point(power_at(x0, nu, n) * entire_factor(d, x0, n), x0, nu);
}

inline drawn_series logarithm_and_entire(dice& d, int n) {
    const mpfr x0 = d.place();
    return at_point((logarithm_at(x0, n) + polynomial({d.weight()}, n)) * entire_factor(d, x0, n), x0, mpfr(0));
}

inline drawn_series pole_and_branch_point(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr beyond = x0 * d.thousandths(1150, 2500) * d.sign();
    const mpfr nu(-1 - d.below(3));
    return at_point(power_at(x0, nu, n) + d.weight() * power_at(beyond, d.exponent(), n), x0, nu);
}

inline drawn_series opposite_sum(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr other = d.exponent();
    return opposite_points(power_at(x0, nu, n) + d.weight() * power_at(mpfr(-x0), other, n), x0, {nu, other});
}

inline drawn_series opposite_product(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr other = d.exponent();
    return opposite_points(power_at(x0, nu, n) * power_at(mpfr(-x0), other, n), x0, {nu, other});
}

inline drawn_series logarithm_and_opposite_power(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr other = d.exponent();
    return opposite_points(logarithm_at(x0, n) + d.weight() * power_at(mpfr(-x0), other, n), x0, {mpfr(0), other});
}

/// nu + something of comparable strength that is not an integer.
inline mpfr comparable(dice& d, const mpfr& nu) { return nu + d.thousandths(-500, 1000) + mpfr(1) / 7919; }

inline drawn_series close_sum(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr further = comparable(d, nu);
    const mpfr beyond = x0 * d.thousandths(1002, 1010) * d.sign();
    return at_point(power_at(x0, nu, n) + d.weight() * power_at(beyond, further, n), x0, nu);
}

inline drawn_series close_product(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr further = comparable(d, nu);
    const mpfr beyond = x0 * d.thousandths(1002, 1010) * d.sign();
    return at_point(power_at(x0, nu, n) * power_at(beyond, further, n), x0, nu);
}

inline drawn_series close_poles(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr beyond = x0 * d.thousandths(1002, 1010) * d.sign();
    return at_point(power_at(x0, mpfr(-1), n) + d.weight() * power_at(beyond, mpfr(-1), n) + entire_term(d, x0, n), x0,
                    mpfr(-1));
}

inline drawn_series near_and_far(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr further = comparable(d, nu);
    const mpfr beyond = x0 * d.thousandths(1050, 2000) * d.sign();
    return at_point(power_at(x0, nu, n) + d.weight() * power_at(beyond, further, n), x0, nu);
}

inline drawn_series weak_and_strong(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr beyond = x0 * d.thousandths(1200, 1600) * d.sign();
    return at_point(d.thousandths(2, 100) * logarithm_at(x0, n) + power_at(beyond, d.exponent(), n), x0, mpfr(0));
}

inline drawn_series pair_and_entire(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    return at_pair(power_of_pair(r, c, nu, n) + entire_term(d, r, n), r, c, nu);
}

inline drawn_series pair_times_entire(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    return at_pair(power_of_pair(r, c, nu, n) * entire_factor(d, r, n), r, c, nu);
}

inline drawn_series pair_of_logarithms(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const auto pair = rescale(quadratic_logarithm_series(c, n), mpfr(1 / r));
    return at_pair(pair * entire_factor(d, r, n) + entire_term(d, r, n), r, c, mpfr(0));
}

inline drawn_series two_pairs(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr beyond = r * d.thousandths(1050, 1800);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    const mpfr other = cosine(d);
    return at_pair(power_of_pair(r, c, nu, n) + d.weight() * power_of_pair(beyond, other, d.exponent(), n), r, c, nu);
}

inline drawn_series pair_and_point(dice& d, int n) {
    const mpfr r = d.thousandths(400, 4000);
    const mpfr c = cosine(d);
    const mpfr nu = d.exponent();
    const mpfr x0 = r * d.sign();
    const mpfr other = d.exponent();
    auto all = at_pair(power_of_pair(r, c, nu, n) * power_at(x0, other, n), r, c, nu);
    all.nearest.push_back({{x0, mpfr(0)}, other});
    return all;
}

inline drawn_series confluent(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    const mpfr further = d.one_of<mpfr>({mpfr(1) / 2, mpfr(1) / 3, mpfr(37) / 100, mpfr(3) / 2});
    return at_point(power_at(x0, nu, n) + d.weight() * power_at(x0, mpfr(nu + further), n) + entire_term(d, x0, n), x0,
                    nu);
}

inline drawn_series squared_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const auto l = logarithm_at(x0, n);
    return at_point(l * l + d.weight() * l + entire_term(d, x0, n), x0, mpfr(0));
}

inline drawn_series power_times_logarithm(dice& d, int n) {
    const mpfr x0 = d.place();
    const mpfr nu = d.exponent();
    return at_point(power_at(x0, nu, n) * logarithm_at(x0, n), x0, nu);
}

/// log(1 - x/x0)/x.
inline power_series<mpfr> shifted_logarithm(const mpfr& x0, int n) {
    const auto longer = logarithm_at(x0, n + 1);
    auto l = power_series<mpfr>::zero(n);
    for (int k = 0; k <= n; ++k) {
        l[k] = longer[k + 1];
    }
    return l;
}

inline drawn_series inverse_logarithm(dice& d, int n) {  // x/log(1 - x/x0): Gregory's numbers
    const mpfr x0 = d.place();
    return at_point(polynomial({mpfr(1)}, n) / shifted_logarithm(x0, n), x0, mpfr(0));
}

}  // namespace population

}  // namespace libration::tests
