// What a law of all coefficients proves of the ratios of Domb and Sykes and of the root test: limit, straight line and
// radius.
#pragma once

#include <optional>

#include "libration/asymptotics/coefficient_law.hpp"

namespace libration::ode {

/// The ratios a_n/a_(n-p), p the stride of the law, tend to `limit` = t*^-p, t* = the nearest singularity - t0, and
/// approach
///     limit (1 - p (1 + exponent)/n),
/// the line of Domb and Sykes: n (1 - ratio/limit) tends to p (1 + exponent).
struct ratio_line {
    int power = 1;  ///< p
    ball limit;
    ball exponent;  ///< a of the leading term (t - t*)^a of the shown function; 0 for a logarithm

    ball at(long n) const { return limit * (ball(1) - (exponent + 1) * power / n); }
};

/// Proved if the singularities that are not proved to be farther than the nearest one are p, so that they are its
/// images under the rotations that the stride is of, and if its leading term is a power x^a or x^a log x with a = 0, 1,
/// .., with a coefficient whose ball excludes 0: by theorems A, B, F and D, since the coefficients of each later term
/// are smaller by a power of n and those of other singularities by a power of their moduli. std::nullopt otherwise, as
/// for a pair of conjugate singularities without a stride, where ratios have no limit.
std::optional<ratio_line> line_of_ratios(const coefficient_law& law);

/// The radius of convergence, the limit superior of |a_n|^(1/n) to the power -1: a ball of the modulus of the nearest
/// singularities, if for one of them the coefficient of the leading term is proved to be nonzero; std::nullopt
/// otherwise.
std::optional<ball> radius_of_law(const coefficient_law& law);

}  // namespace libration::ode
