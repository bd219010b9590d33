// Proved bounds of the radius of convergence: from below by a covering, from above by a loop (theorems L and C).
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/plane/complex_disc.hpp"

namespace libration::ode {

/// The rotations exp(2 pi i/rotation) of the plane about the initial point that leave the set of singularities of a
/// solution invariant; the reflection in the real axis always does, since equations and initial values are real.
struct plane_symmetry {
    int rotation = 1;
};

/// From the exact zeros of the initial values (tape::about_start): unknown i is t^r_i times a series in t^rotation.
plane_symmetry symmetry_of(const explicit_system& system);

/// A disc of a covering, rounded: for figures and tests.
struct covering_disc {
    std::complex<double> centre;
    double radius = 0;
};

/// The result of a covering.
struct covering {
    bool complete = false;
    /// The computed discs; the first is about the initial point.
    std::vector<covering_disc> discs;
    /// If it is not complete: the modulus up to which no part is missing.
    ball covered;
    std::string reason;
};

/// Limits of the cost of a covering.
struct covering_limits {
    /// The minimum length of a cell relative to rho, as 2^-bits.
    long finest_bits = 200;
    long most_discs = 50'000;
};

/// Theorem L: discs D(c_k, rho_k) of theorem T along paths whose modulus does not exceed that of their end; if every
/// point with |z| <= rho of one sector of the symmetry lies in the disc about 0 or in a D(c_k, rho_k) with |c_k| <=
/// |z|, the radius of convergence about the initial point is at least rho. Cells r1 <= |z| <= r2 of a range of angles
/// are halved until the four corners of each lie in a disc whose centre is not farther from 0 than r1: |z - c| is
/// convex in |z| and grows with the angle. rho is exact. Without a proof the result contains the reason: a singularity
/// at a smaller distance, or too few bits.
covering covered_disc(const complex_flow& flow, const ball& rho, const plane_symmetry& symmetry,
                      const covering_limits& limits);

/// The evidence that a loop encloses a singularity.
enum class loop_evidence {
    none,
    /// The values of an unknown at the end and the beginning differ.
    change,
    /// The contour integral of ((z - c)/d)^power times an unknown is nonzero.
    integral
};

/// A loop of discs around a point.
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

/// Theorem C: from the initial point along the corners of a path, then straight to the loop, and once around `centre`
/// in a regular polygon of radius `reach`, by discs of theorem T. If the change of an unknown along the loop, or one of
/// its contour integrals up to the power `most_power`, is proved to be nonzero, some path in the polygon and the part
/// it cuts off ends in a singularity of this very unknown, of the branch reached by the path: the monodromy theorem
/// holds for each unknown by itself. Only the unknowns and lower derivatives at the indices `of` are examined. All
/// offsets are from the initial point, exact. Throws precision_exhausted if the path or the loop cannot be completed
/// with so many bits: its radii fall below 2^-shortest of the remaining path.
loop_result loop_about(const complex_flow& flow, const std::vector<complex_ball>& corners, const complex_ball& centre,
                       const magnitude& reach, int most_power, const std::vector<std::size_t>& of);

}  // namespace libration::ode
