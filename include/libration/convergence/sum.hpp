// The value of the function that a list of coefficients defines, with an uncertainty: the vote of several summations.
//
// Partial sums inside the radius of convergence; Pade approximants; differential approximants continued along the real
// axis; Euler's map and the map of the cut plane if the nearest singularity is real and on the other side; for a list of
// radius zero and Gevrey order s, Borel sums by Pade approximants and by the map of the cut plane of the transform. Each
// is computed from a_0 .. a_n for n = N, N-1, N-2; the root mean square of its changes is its step (sum_vote.hpp).
//
// Heuristic: finitely many coefficients prove nothing about the others. The uncertainty is calibrated on series with
// known values (tests/convergence/sum_population_test.cpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libration/convergence/verdict.hpp"

namespace libration::convergence {

/// f(x) with at least one certain digit, or the reason why there is no value.
struct series_value {
    std::optional<mpfr> value = std::nullopt;
    mpfr uncertainty = mpfr(0);             ///< absolute
    std::vector<std::string> methods = {};  ///< that agree with it
    std::string note;                       ///< why there is no value, or on which branch it is
};

/// The digits that the numbers of an exact list of order N should have for its sums.
long digits_of_list(int order);

/// The values at real points; a[n] of the list is known to noise[n], absolutely, or exactly if `noise` is empty. Beyond
/// nine tenths of the radius a value needs two kinds of methods that agree, or two equations that the whole list
/// satisfies, and it is the one of the branch reached along the real axis. No value if a singularity is between 0 and
/// the point, on a Stokes line, where the Borel transform is singular on the ray of the point, and if a coefficient
/// contradicts the others. One verdict on the list, and for each point O(N) steps of O(N^2) operations.
std::vector<series_value> sums_of_list(const series_list& list, std::span<const mpfr> noise,
                                       std::span<const mpfr> points, const task_runner& run = run_in_order);

}  // namespace libration::convergence
