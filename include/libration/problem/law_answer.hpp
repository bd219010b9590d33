// The law of all Taylor coefficients of a solution in words and decimals, and coefficients by it.
#pragma once

#include <vector>

#include "libration/problem/proved_law.hpp"

namespace libration {

struct law_report {
    /// One row for each singularity in |t - t0| <= rho: position_re, position_im, modulus, kind (pole of order m,
    /// branch point, logarithm; none in the only row without any), exponent, coefficient_re, coefficient_im, rho, mean,
    /// first. The coefficient is that of (t - t*)^exponent or log(t - t*), at branch points that of (1 - (t - t0)/(t* -
    /// t0))^exponent; mean is C, first the least n of the law as it is printed. Proved. The notes are the law, its
    /// error and what is proved.
    answer singularities;
    /// One row for each order: n, value and by: law, recurrence, or symmetry for an exact 0. Proved.
    answer coefficients;
    /// Whether a coefficient has less than the requested digits.
    bool complete = true;
};

/// Throws error of the subject "unknown" for a name that is none, of the kind undecided as coefficient_law::of. A
/// coefficient to which the law does not give the digits is computed by the recurrence up to a power of 20000.
law_report law_of(const ode::explicit_system& system, const law_question& asked, const std::vector<long>& orders,
                  const request& how);
/// law_report::coefficients of a law that is proved already; `complete` may be null.
answer coefficients_of_law(const proved_law& law, const std::vector<long>& orders, long digits,
                           bool* complete = nullptr);

}  // namespace libration
