// What a proved singularity contributes to every Taylor coefficient, and what is left of it: the formulas of theorems A and B.
#pragma once

#include <vector>

#include "libration/plane/algebraic_point.hpp"
#include "libration/plane/enclosed_poles.hpp"

namespace libration::ode {

/// sum over j of c_j (-1)^j binomial(n + j - 1, j - 1) place^(-n-j), of a pole, and of its mirror image unless it is real. By
/// repeated squaring: a power of a complex ball by single products would widen like sqrt 2^n.
ball pole_coefficient(const pole_terms& of, long n);

/// The terms of a branch point in theorem B, a = j/q:
///     place^-n sum over -p <= j <= J of c_j Gamma(n - a)/(Gamma(-a) n!),
/// whose terms with a = 0, 1, 2, .. are 0, for 0 < d = rho/|place| - 1 < reach^q.
class branch_terms {
public:
    branch_terms(algebraic_point of, double rho);

    const algebraic_point& of() const { return of_; }
    /// The least n for which the bounds hold with these J: n > a_1 = J_1/q, J_1 the first index above J without the factor q, and n > (J/q)(1 +
    /// d)/d.
    long first(int terms) const;
    /// The sum for J = terms, and of the mirror image unless the point is real.
    ball coefficient(long n, int terms) const;
    /// A bound of what theorem B adds to C rho^-n:
    ///     |place|^-n (sum over j <= J, q not a divisor of j, of |c_j| |sin pi a|/pi I_a(n) + sum over J < j <= L of |c_j| |sin pi a|/pi
    ///     Gamma(1 + a) Gamma(n - a)/n! + size reach^-(L_1+p)/(1 - e) Gamma(1 + a_1) Gamma(n - a_1)/(pi n!)),
    /// I_a(n) = d^a (1 + d)^-n/(n - a (1 + d)/d) for a > 0, d^a (1 + d)^-n/n for a < 0, e = d^(1/q)/reach, for q = 2 d/reach^2; L is the last known
    /// coefficient with n > L_1/q. Both points of a pair. n >= first(terms).
    ball bound(long n, int terms) const;

    /// The same for all n >= first(terms) = N at once: circle rho^-n + slit |place|^-n Gamma(n - a_1)/n!.
    struct uniform_bound {
        ball circle, slit;
        int index = 0;  ///< J_1
    };
    uniform_bound uniform(int terms) const;

private:
    ball circle_terms(long n, int terms) const;
    ball slit_term(int j) const;
    ball rest_beyond(int terms) const;

    algebraic_point of_;
    ball rho_, d_, modulus_;
    std::vector<ball> sizes_;  ///< |c_j| |sin pi j/q|/pi
};

/// Gamma(n - a)/n! for a = j/q < n.
ball gamma_quotient(long n, int j, int q);

}  // namespace libration::ode
