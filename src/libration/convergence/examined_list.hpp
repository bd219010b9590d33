// A list with a family of approximants and the clusters of their roots.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cluster_answer.hpp"

namespace libration::convergence {

/// Fewer coefficients show a singularity only if they satisfy an exact equation.
inline constexpr int fewest_coefficients = 12;

/// A family, its clusters, and those of them that count.
struct examined_list {
    approximant_family family;
    std::vector<root_cluster> clusters;
    std::vector<const root_cluster*> strong;
};

/// A list that is known to `noise` of its size.
std::unique_ptr<examined_list> examined(std::span<const mpfr> b, coefficient_class of, double noise,
                                        const task_runner& run);

/// `whole`, a list without a cluster that counts, or the longest of its first 80, 62, 48, 37 and 28 % that has one. An
/// exact equation without singularities has none in its parts either.
std::unique_ptr<examined_list> with_cuts(std::unique_ptr<examined_list> whole, std::span<const mpfr> b,
                                         coefficient_class of, double noise, const task_runner& run);

}  // namespace libration::convergence
