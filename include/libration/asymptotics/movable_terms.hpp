// What a movable singularity of a polynomial system contributes to every Taylor coefficient: the formulas of theorem D.
#pragma once

#include <vector>

#include "libration/asymptotics/fixed_point_terms.hpp"
#include "libration/plane/balance/movable_point.hpp"

namespace libration::ode {

/// The terms c x^a log(x)^k up to Re a <= J of an expansion y = sum of c x^a log(x)^k + rest are
///     place^-n c d^k/da^k [Gamma(n - a)/(Gamma(-a) n!)],
/// for 0 < d = rho/|place| - 1 < reach; those with a negative Re a always count.
class movable_terms {
public:
    /// Throws precision_exhausted unless d is proved to be in this interval with the variables inside their polydisc, or the point has one value.
    movable_terms(movable_point of, double rho);

    const movable_point& of() const { return of_; }
    /// The least n for which the bounds hold with these J.
    long first(int terms) const;
    /// The sum of the terms, and of the mirror image unless the point is real.
    ball coefficient(long n, int terms) const;
    /// A bound of what theorem D adds to C rho^-n. On both sides of the slit x = -w terms jump as those of fixed_point_terms; the rest by at most
    /// 2 G (w/d)^b, G = d^-m rest kappa^N, b = N (1 - h D) - m, N the least weight of the rest, D a bound of the degrees of logarithms relative to their weights,
    /// kappa that of the variables at w = d with |log d| + pi + 1/(e h), h = 1/8. So the bound is |place|^-n/pi times
    ///     sum over Re a <= J of |c| f H^p d^(-hp) I_(Re a + hp)(n) + sum over Re a > J of |c| f H^p d^(Re a - b') Gamma(b' + 1) Gamma(n - b')/n!
    ///     + G d^-b' Gamma(b' + 1) Gamma(n - b')/n!,
    /// p = k, f = cosh(pi Im a), or for whole a p = k - 1, f = pi k, H = |log d| + pi + 1/(e h); b' <= Re a - hp, b and n/2.
    ball bound(long n, int terms) const;
    /// The same for all n >= first(terms) at once.
    fixed_point_terms::uniform_bound uniform(int terms) const;
    /// The terms with more than one value or a negative exponent, those with the least Re a and the highest k first.
    std::vector<fixed_point_terms::singular_term> leading() const;

private:
    struct jump;
    std::vector<jump> jumps(int terms) const;
    ball rest_index() const;
    ball circle_part(const jump& of, long n) const;

    movable_point of_;
    ball rho_, d_, modulus_, size_;
    ball rest_;  ///< G
};

}  // namespace libration::ode
