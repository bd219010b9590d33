// Power series with exponents and logarithms of solutions of linear equations, with a proved bound of all their coefficients.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/plane/fuchsian_point.hpp"
#include "libration/plane/series_disc.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// sum over l of x^l sum over i <= r of c_il x^i (d/dx)^i in balls, c_r0 != 0.
struct local_operator {
    std::vector<std::vector<complex_ball>> c;
    std::vector<complex_ball> exponents;  ///< the r roots of the indicial polynomial
    std::vector<complex_ball> zeros;      ///< the zeros x_j of sum of c_rl x^l with their multiplicities
    complex_ball place;                   ///< the point

    /// A lower bound of all |x_j|; infinite without any.
    double nearest() const;
    /// The bits by which the balls of n coefficients widen relative to the sizes reach^-n, per coefficient: the recurrence of their radii is that
    /// of the moduli |c_il|. An estimate.
    double bits_lost(double reach) const;
    /// An element of the field of the point.
    complex_ball value_of(const rational_polynomial& element) const { return value_at(element, place); }
};

/// About an ordinary point t0 + centre, x = t - t0 - centre. The roots are those of p_r with their multiplicity.
local_operator operator_about(const linear_equation& of, const complex_ball& centre,
                              const std::vector<complex_ball>& roots);
/// At the root `place` of the factor of a regular singular point, x = 1 - (t - t0)/place, or t - t0 where that is 0; the roots are the others. Throws precision_exhausted if
/// exponents that are not rational are not proved to be different, also by integers.
local_operator operator_at(const fuchsian_point& of, const complex_ball& place,
                           const std::vector<complex_ball>& others);

/// The purpose of a series: evaluated at |x| <= at < reach with so many bits, and at least so many terms.
struct series_demand {
    double reach = 0;
    double at = 0;
    long bits = 0;
    long least_terms = 0;
};

/// y = x^e sum over n >= 0, k < K of v[n][k] x^n log(x)^k/k!, with |v[n]| = sum over k of |v[n][k]| <= size reach^-n for all n.
///
/// Proof. Division by h_r = sum of c_rl x^l gives x^r y^(r) + sum over i < r of A_i(x) x^i y^(i) = 0, A_i = sum of A_il x^l, and
///     P(e + n + S) v_n = - sum over l = 1 .. n, i < r of A_il [e + n - l + S]_i v_(n-l),   P(e) = product of (e - e_k),
/// [e]_i = e (e - 1) .. (e - i + 1), |S| <= s, s = 0 if K = 1, otherwise 1. For n >= N above all b_k = |e - e_k| + s the norm of [e + n - l + S]_i/P(e + n +
/// S) is at most q_i/n, q_i = N product over j < i of (N + |e| + j + s)/product over k of (N - b_k), which decreases with N. If sum over i of q_i sum over l >=
/// 1 of |A_il| reach^l <= N, the bound for all indices below n implies that for n. The sums over l beyond the computed ones follow from |A_il|
/// <= sum of |c_im| R^m/(|c_r0| product of (1 - R/|x_j|)) R^-l, reach < R < |x_j|.
class frobenius_series {
public:
    /// The first v, up to the last index at which some are free. Throws precision_exhausted if no N is found.
    frobenius_series(const local_operator& of, complex_ball exponent, std::vector<std::vector<complex_ball>> first,
                     const series_demand& demand);

    /// The sum of factors[k] all[k], series with one exponent and one reach.
    static frobenius_series combination(const std::vector<frobenius_series>& all,
                                        const std::vector<complex_ball>& factors);

    const complex_ball& exponent() const { return exponent_; }
    /// K.
    std::size_t powers_of_logarithm() const { return powers_; }
    long terms() const { return static_cast<long>(v_.size()); }
    const std::vector<complex_ball>& coefficient(long n) const { return v_[static_cast<std::size_t>(n)]; }
    const ball& reach() const { return reach_; }
    const magnitude& size() const { return size_; }

    /// y^(d)(x)/d! for d < count, by the principal logarithm and power, 0 < |x| < reach.
    std::vector<complex_ball> derivatives(const complex_ball& x, std::size_t count) const;
    /// A bound of |y| for low <= |x| <= high < reach and all |arg x| <= pi, exact.
    ball bound(const ball& low, const ball& high) const;

private:
    frobenius_series() = default;
    long first_proved(const local_operator& of, double reach) const;
    void extend(const local_operator& of, const series_demand& demand);
    std::vector<std::vector<complex_ball>> images(const std::vector<complex_ball>& v, long n, std::size_t order) const;
    ball rest_of_sum(const ball& q, long shift, std::size_t power) const;

    complex_ball exponent_;
    std::size_t powers_ = 1;
    std::vector<std::vector<complex_ball>> v_;
    ball reach_;
    magnitude size_;
};

/// |z|, and its enclosure from the parts.
ball modulus_in_balls(const complex_ball& z);

}  // namespace libration::ode
