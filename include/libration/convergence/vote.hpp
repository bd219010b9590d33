// The vote of a family of approximants: where their roots recur, and what they agree on there.
//
// One fit proves little: its roots may be spurious, and its change from one length to the next is small or large by
// accident. A root near which the roots of many tracks lie, each within a few of its own steps, is another matter: the
// share of a cluster is the geometric mean, over all voters, of
//     0.7 (rho/(4 s)) / (1 + (d/(4 s))^2)^(3/2) + 0.3,
// s the step of a voter from length to length, d its distance from the leader, rho the size of the territory: the odds
// that a voter votes for this place rather than for any other.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "libration/convergence/family.hpp"

namespace libration::convergence {

/// A weighted median of exponents, the 75 % quantile of the distances from it, and the median step from length to length.
struct exponent_vote {
    mpfr value = mpfr(0);
    double spread = 0, step = 0;
};

/// What the tracks agree on near a place, at one length.
struct root_consensus {
    int length = 0;
    complex_number<mpfr> position;                           ///< weighted median of the top voters
    double spread = 0;                                       ///< weighted 75 % quantile of their distances from it
    double step = 0;                                         ///< their median step from length to length
    double share = 0;                                        ///< the odds that one voter votes for it
    bool exact = false;                                      ///< an exact equation is among the top
    exponent_vote exponent;                                  ///< of the top voters
    bool assumed = false;                                    ///< fewer than three of the top determine an exponent
    std::optional<exponent_vote> determined = std::nullopt;  ///< if so, of the other voters that do
    double second = 0;                                       ///< the second exponent, for a multiple root
    int type = 11;                                           ///< most frequent type of root among the top
    bool irregular = false;
    std::vector<std::size_t> tracks = {};            ///< of the top voters, the sharpest first
    int orders = 0;                                  ///< M of equations that occur among the members
    int agreeing = 0;                                ///< number of members
    double slope = 0;                                ///< of the exponent against the position, over the members
    double residual = 0;                             ///< median distance of their exponents from the line of that slope
    std::vector<std::complex<double>> members = {};  ///< (position, exponent), real parts

    double modulus() const { return std::abs(place()); }
    std::complex<double> place() const { return {position.re.convert_to<double>(), position.im.convert_to<double>()}; }
    /// |position - other's|, without cancellation in double.
    double distance_to(const root_consensus& other) const;
    bool is_regular_type() const { return type % 11 == 0 || type % 10 == 0; }
};

/// A place where roots recur, and the consensus there at each voting length, the last at N.
struct root_cluster {
    std::complex<double> centre;
    double distance = 0;
    std::vector<std::optional<root_consensus>> history;
    double noise = 0;  ///< of the list, relative

    const root_consensus& now() const { return *history.back(); }
};

/// The clusters with a consensus at N, within 1.6 times the nearest sharp one (10 times for an exact equation).
std::vector<root_cluster> clusters_of(const approximant_family& family);

}  // namespace libration::convergence
