// The family of differential approximants of a list: many tracks at many lengths, so that their agreement can be counted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libration/approximant/differential.hpp"
#include "libration/convergence/list.hpp"

namespace libration::convergence {

/// Which coefficients a list holds: b_k = a_(first + stride k).
struct coefficient_class {
    int first = 0;
    int stride = 1;
};

/// The fits of a list b_0 .. b_N in a unit that makes the radius about 1.
struct approximant_family {
    int order = 0;             ///< N
    mpfr unit = mpfr(1);       ///< x = unit y; the roots are values of y
    std::vector<mpfr> scaled;  ///< b_k unit^k
    std::vector<differential_track> tracks;
    std::vector<int> lengths;  ///< at which the fits vote, ascending; the last one is N
    std::vector<differential_fit> fits;

    /// At least three tracks are exact: the list satisfies a linear differential equation.
    bool is_exact() const;
    /// A root of an exact equation in the annulus.
    bool has_exact_root() const;
};

/// M = 1, 2, 3; L = 0, 1, .. with growing gaps up to N - 4 M - 4; offsets 0, and 1 for M > 1 and L <= 6; and Pade
/// approximants of f and of D f for 0.3 N <= L <= N - 6, every L up to 24, to which a meromorphic f or derivative
/// is exact up to a geometric error.
std::vector<differential_track> tracks_for(int order, coefficient_class of = {});

/// The last six of 14, 16, 19, 21, .. (factors 1.15, the same for all lists) from 0.38 N to N, and N.
std::vector<int> voting_lengths(int order);

/// The fits at each voting length g and at g - 1 and g - 2. If three tracks are exact without a root in the annulus, the
/// roots between 0.02 and 50 units are computed instead. At least 12 coefficients, known to `noise` of their size.
approximant_family family_of(std::span<const mpfr> b, coefficient_class of = {}, double noise = 0,
                             const task_runner& run = run_in_order);

}  // namespace libration::convergence
