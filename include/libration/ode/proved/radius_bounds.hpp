// Proved bounds of the radius of convergence: from below by a covering, from above by a loop (theorems L and C).
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/proved/complex_disc.hpp"

namespace libration::ode {

/// The turns exp(2 pi i/rotation) of the plane about the start that the singularities of a solution share; the
/// reflection in the real axis always does, for equations and starts are real.
struct plane_symmetry {
    int rotation = 1;
};

/// From the exact zeros of the start (tape::about_start): unknown i is t^r_i times a series in t^rotation.
plane_symmetry symmetry_of(const explicit_system& system);

/// A disc of a covering, rounded: for figures and tests.
struct covering_disc {
    std::complex<double> centre;
    double radius = 0;
};

/// How a covering ended.
struct covering {
    bool complete = false;
    /// Those that were made; the first is about the start.
    std::vector<covering_disc> discs;
    /// Where it is not complete: the modulus from 0 up to which no part is missing.
    ball covered;
    std::string reason;
};

/// What a covering may cost.
struct covering_limits {
    /// The least length of a cell relative to rho, as 2^-bits.
    long finest_bits = 200;
    long most_discs = 50'000;
};

/// Theorem L: discs D(c_k, rho_k) of theorem T along paths of no larger modulus than their end; where every point with
/// |z| <= rho of one sector of the symmetry lies in the disc about 0 or in a D(c_k, rho_k) with |c_k| <= |z|, the
/// radius of convergence about the start is at least rho. Cells r1 <= |z| <= r2 of a fan of angles are halved until the
/// four corners of each lie in a disc whose centre is no farther from 0 than r1: |z - c| is convex in |z| and grows
/// with the angle. rho is exact. Without a proof it says why: a singularity at a smaller distance, or too few bits.
covering covered_disc(const complex_flow& flow, const ball& rho, const plane_symmetry& symmetry,
                      const covering_limits& limits);

/// What shows that a loop has a singularity in it.
enum class loop_evidence {
    none,
    /// End and start of an unknown differ.
    change,
    /// The contour integral of ((z - c)/d)^power times an unknown is nonzero.
    integral
};

/// A loop of discs round a point.
struct loop_result {
    loop_evidence evidence = loop_evidence::none;
    std::size_t unknown = 0;
    int power = 0;
    /// An enclosure of the difference, or of the integral.
    complex_ball value;
    /// Upper bounds of |z| over the path and the loop, and of |z - centre| over the loop.
    ball farthest;
    magnitude reach;
    long discs = 0;
    /// The corners of the loop.
    std::vector<complex_ball> polygon;
};

/// Theorem C: from the start along the corners of a path, further straight to the loop, and once round `centre` in a
/// regular polygon of radius `reach`, by discs of theorem T. Where end minus start of an unknown, or one of the round
/// integrals up to the power `most_power`, is proved not to be 0, some path in the polygon and what it cuts off ends in
/// a singularity of this very unknown, of the branch that the path reaches: the monodromy theorem holds for each unknown
/// by itself. Only the unknowns and lower derivatives at the indices `of` are looked at. All offsets are from the start,
/// exact. Throws precision_exhausted
/// where the path or the loop is not reached with so many bits: its radii fall below 2^-shortest of the way that is
/// left.
loop_result loop_about(const complex_flow& flow, const std::vector<complex_ball>& corners, const complex_ball& centre,
                       const magnitude& reach, int most_power, const std::vector<std::size_t>& of);

}  // namespace libration::ode
