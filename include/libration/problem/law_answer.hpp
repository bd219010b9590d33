// The law of all Taylor coefficients of a solution in words and decimals, and coefficients by it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// The request of a law (ode::coefficient_law).
struct law_question {
    /// An unknown or a derivative of it, y or th'; the first unknown if it is empty.
    std::string show = {};
    std::optional<exact> within = {};
    /// The last index of the expansions at branch points.
    int terms = 60;
    /// The coefficients to compute.
    std::vector<long> orders = {};
};

struct law_report {
    /// One row for each singularity in |t - t0| <= rho: position_re, position_im, modulus, kind (pole of order m, branch point,
    /// logarithm; none in the only row without any), exponent, coefficient_re, coefficient_im, rho, mean, first. The coefficient is that of (t - t*)^exponent
    /// or log(t - t*), at branch points that of (1 - (t - t0)/(t* - t0))^exponent; mean is C, first the least n of the law as it is
    /// printed. Proved. The notes are the law, its error and what is proved.
    answer singularities;
    /// One row for each order: n, value and by: law, recurrence, or symmetry for an exact 0. Proved.
    answer coefficients;
    /// Whether a coefficient has less than the requested digits.
    bool complete = true;
};

/// Throws error of the subject "unknown" for a name that is none, of the kind undecided as coefficient_law::of. A coefficient to which the law
/// does not give the digits is computed by the recurrence up to a power of 20000.
law_report law_of(const ode::explicit_system& system, const law_question& asked, const request& how);

}  // namespace libration
