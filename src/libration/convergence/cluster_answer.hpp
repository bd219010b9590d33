// What a cluster of roots states: its position and exponent with calibrated uncertainties, and its kind.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/convergence/verdict.hpp"

namespace libration::convergence {

/// A cluster with the length whose consensus is used, and the relative uncertainty of the position.
struct placed_cluster {
    const root_cluster* of;
    std::size_t at;
    double uncertainty;

    const root_consensus& consensus() const { return *of->history[at]; }
    double modulus() const { return consensus().modulus(); }
    double lower() const { return modulus() * (1 - uncertainty); }
    double upper() const { return modulus() * (1 + uncertainty); }
};

/// Relative: the larger of spread and step, without the drift.
double width_of(const root_consensus& consensus);

/// The relative uncertainty of the consensus at one length: 8 times (20 for a share below 30) the largest of its spread,
/// its step and its drift from shorter lengths, or 40 times the first two if there is no length of at most 0.93 of it.
/// The factor is the calibrated one.
double position_uncertainty(const root_cluster& cluster, std::size_t at);

/// The consensus at N, or an earlier one that is three times sharper even with three times its uncertainty and is not
/// contradicted by that at N.
placed_cluster placed(const root_cluster& cluster);

/// The exponent at a length and its uncertainty, by the same rule. One that the top voters assume counts only if the
/// position is as sharp as that of a pure pole (kind_at) and the voters that determine one agree with it.
std::pair<mpfr, double> exponent_at(const root_cluster& cluster, std::size_t at);

/// The kind at a length, if the list satisfies an exact equation, or: a pole or a logarithm, if the position is sharp to
/// 10^(-N/3) or to the noise of the list; another kind, if it is the same at the two lengths before.
singularity_kind kind_at(const root_cluster& cluster, std::size_t at);

/// Clusters that count, nearest first: with a share of at least `least`, or of 4 and the same position at the last four
/// lengths; without the nearest ones at which the list is regular (apparent_root.hpp).
std::vector<const root_cluster*> strong_clusters(const approximant_family& family,
                                                 const std::vector<root_cluster>& clusters, double least = 10);

/// The clusters on the circle of convergence, the sharpest first: the nearest one, and those that its uncertainty
/// reaches and whose angle to it is a multiple of 30 degrees.
std::vector<placed_cluster> ring_of(const std::vector<const root_cluster*>& strong);

/// The modulus of a cluster with a share of 3 to 10 that would be nearer than `below` units, and is at the same place, to
/// 3 %, at the length before; of a rounded list also at one of at most 0.93 of the length.
std::optional<double> doubtful_nearer(const approximant_family& family, const std::vector<root_cluster>& clusters,
                                      double below);

}  // namespace libration::convergence
