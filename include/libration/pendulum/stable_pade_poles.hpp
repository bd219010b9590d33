// Pade poles with correct digits: their systems are ill-conditioned, so they are computed at increasing precisions.
#pragma once

#include <algorithm>
#include <string>

#include "libration/digits/agreed_values.hpp"
#include "libration/pendulum/pade_poles.hpp"

namespace libration::pendulum {

/// Whether two computations found the same poles to `digits` significant digits of every number, and two more.
inline bool same_poles(const pade_poles<mpfr>& a, const pade_poles<mpfr>& b, long digits) {
    const auto close = [&](const mpfr& x, const mpfr& y) {
        return abs(x - y) <= abs(y) * pow(mpfr(10), static_cast<int>(-digits - 2));
    };
    const auto both = [&](const complex_number<mpfr>& x, const complex_number<mpfr>& y) {
        return close(x.re, y.re) && close(x.im, y.im);
    };
    return a.denominator_degree == b.denominator_degree &&
           std::equal(a.poles.begin(), a.poles.end(), b.poles.begin(), b.poles.end(),
                      [&](const auto& p, const auto& q) {
                          return both(p.time, q.time) && both(p.residue, q.residue) && close(p.distance, q.distance);
                      });
}

/// z without the real or imaginary part that is below `negligible` of |z|: a part that is 0 by symmetry up to rounding.
template <rounding_scalar T>
complex_number<T> without_noise(const complex_number<T>& z, const T& negligible) {
    using std::abs;
    const T least = modulus_of(z) * negligible;
    return {abs(z.re) < least ? T(0) : z.re, abs(z.im) < least ? T(0) : z.im};
}

/// The poles with `digits` correct digits: recomputed with more working digits until the result does not change. A
/// pivot or a part of a complex number below 10^-(half of the working digits) of its scale counts as 0. Throws
/// error of the kind undecided when 20000 working digits are not enough.
inline pade_poles<mpfr> stable_pade_poles(const motion& m, int order, long digits) {
    const auto compute = [&](const precision_run& run) {
        const mpfr negligible = pow(mpfr(10), static_cast<int>(-run.more / 2));
        auto now = poles_of_speed<mpfr>(m, order, negligible);
        for (std::size_t i = 0; now && i < now->poles.size(); ++i) {
            now->poles[i].time = without_noise(now->poles[i].time, negligible);
            now->poles[i].residue = without_noise(now->poles[i].residue, negligible);
        }
        return now;
    };
    const auto same = [&](const pade_poles<mpfr>& a, const pade_poles<mpfr>& b) { return same_poles(a, b, digits); };
    return until_two_agree({0, digits + 40 + 2L * order, 20'000, digit_growth::by_half},
                           "a Pade pole of order " + std::to_string(order), compute, same);
}

}  // namespace libration::pendulum
