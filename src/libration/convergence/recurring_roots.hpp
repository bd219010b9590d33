// Where the roots of many fits recur.
#pragma once

#include <complex>
#include <vector>

#include "libration/convergence/family.hpp"

namespace libration::convergence {

/// A root, and its distance to the nearest roots of half of the other fits.
struct recurring_root {
    std::complex<double> at;
    double distance;
};

/// The roots of the fits at N, N - 1 and N - 2 that recur to 6 %, the sharpest first and at most twelve; of exact equations
/// alone if there are three. Two that many fits tell apart, though others see them as one, are two.
std::vector<recurring_root> recurring_roots(const approximant_family& family);

/// How far the votes for a root may lie from it: 0.4 of the distance to the next one, its conjugate included.
double territory_of(const recurring_root& cluster, const std::vector<recurring_root>& all);

}  // namespace libration::convergence
