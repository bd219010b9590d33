// What a regular singular point of a linear equation contributes to every Taylor coefficient: the formulas of theorem F.
#pragma once

#include <optional>
#include <vector>

#include "libration/plane/frobenius_series.hpp"

namespace libration::ode {

/// A part x^e (V_0 + V_1 log x + ..) of the local expansion of a solution, and e if it is rational.
struct local_part {
    frobenius_series series;
    std::optional<rational> exponent;

    bool has_integer_exponent() const { return exponent && denominator(*exponent) == 1; }
    /// Whether it has one value about the point: the powers are whole numbers without logarithms.
    bool has_single_values() const { return has_integer_exponent() && series.powers_of_logarithm() == 1; }
};

/// Near `place` = t* - t0 the solution is the sum of the parts, x = 1 - (t - t0)/place. The terms up to x^(e+J) of theorem F are, a = e + j,
///     place^-n v_jk (1/k!) d^k/da^k [Gamma(n - a)/(Gamma(-a) n!)],
/// for 0 < d = rho/|place| - 1 < reach.
class fixed_point_terms {
public:
    /// Throws precision_exhausted unless d is proved to be in this interval, or all parts have one value.
    fixed_point_terms(complex_ball place, bool real, std::vector<local_part> parts, double rho);

    const complex_ball& place() const { return place_; }
    bool is_real() const { return real_; }
    const std::vector<local_part>& parts() const { return parts_; }
    /// The least n for which the bounds hold with these J.
    long first(int terms) const;
    /// The sum of the terms, and of the mirror image unless the point is real.
    ball coefficient(long n, int terms) const;
    /// A bound of what theorem F adds to C rho^-n. On both sides of the slit x = -w; x^a log(x)^k/k! jumps there by at most 2 f w^(Re a) (|log w| + pi)^m,
    /// f = cosh(pi Im a)/k!, m = k, or f = pi/(k-1)!, m = k - 1 for whole a, and (|log w| + pi) <= H max(w/d, d/w)^h, H = |log d| + pi + 1/(e h), h =
    /// 1/8. So the bound is |place|^-n/pi times the sums over the parts of
    ///     sum over j <= J of |v_jk| f H^m d^(-hm) I_(Re a + hm)(n),
    ///     sum over j > J of |v_jk| f H^m d^(hm) Gamma(b + 1) Gamma(n - b)/n!,  b = Re a - hm,
    /// I_a as in branch_terms; beyond the known coefficients that have n > b, by size reach^-j/(1 - d/reach).
    ball bound(long n, int terms) const;

    /// The same for all n >= first(terms) at once: circle rho^-n + slit |place|^-n Gamma(n - index)/n!.
    struct uniform_bound {
        ball circle, slit;
        rational index;
    };
    uniform_bound uniform(int terms) const;

    /// c x^a log(x)^k/k!, c not exactly 0: the terms with more than one value or a negative exponent, those with the least Re a and
    /// the highest k first.
    struct singular_term {
        complex_ball exponent, coefficient;
        std::optional<rational> exact;
        int power = 0;
    };
    /// The first four or more of each part; empty if no part has any.
    std::vector<singular_term> leading() const;

private:
    struct jump;
    std::vector<jump> jumps_of(const local_part& of) const;
    long last_of(const local_part& of, int terms) const;
    ball circle_term(const local_part& of, long j, long n) const;
    ball slit_factor(const local_part& of, long j, long n) const;

    complex_ball place_;
    bool real_;
    std::vector<local_part> parts_;
    ball rho_, d_, modulus_;
};

}  // namespace libration::ode
