// Singularities and the radius of convergence of any system, proved: what a search found, by theorems L and C.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/proved/radius_bounds.hpp"
#include "libration/ode/singularity/singularity_map.hpp"

namespace libration::ode {

/// A singularity of an unknown in a disc, and what showed it.
struct proved_singularity {
    complex_number<mpfr> centre;  ///< relative to the start
    magnitude reach;              ///< the radius of the disc about it
    /// Of the unknown itself or of one of its lower derivatives, whose index in the whole system it holds.
    loop_result evidence;
    /// Of the pole that it is proved to be, by a zero in regular coordinates; 0 where that is not proved.
    int pole_order = 0;
    /// Why it is not proved; empty where it is.
    std::string refusal = {};
};

/// Whether there is exactly one pole within `reach` of an exact offset, of the order that regular_coordinates says:
/// along the corners from the start and half of the rest, further in those coordinates, where the way ends in a disc
/// about the offset m. With q the one that has a simple zero there, Q an enclosure of q' over the box Z of that reach
/// about m: where m - q(m)/Q lies inside Z, q has one zero in Z, there (interval Newton: z -> m - q(m)/A(z), A(z) in Q
/// the mean slope between m and z, maps Z into it); at a pole of order 2 p = 0 is v = 0 where the other factor of p^2
/// excludes 0. False where it is not proved with so many bits.
bool is_pole_near(const explicit_system& system, const std::vector<complex_ball>& corners, const complex_ball& offset,
                  const magnitude& reach, long bits, const proof_route& route = {});

/// Theorem C for a singularity that was found to more digits: some path in a polygon within `reach` of its offset ends
/// in a singularity of the branch that its path reaches, of the unknown that it was found for and of no other; and
/// whether that is a pole, where the equation of this unknown has regular coordinates. The path goes through the
/// subsystem of what the unknown depends on. More bits are taken until the loop closes. Throws error of the kind
/// undecided where none of the functionals of this unknown excludes 0, or a million bits do not suffice.
proved_singularity prove_singularity(const explicit_system& system, const found_singularity& found, const mpfr& reach,
                                     const proof_route& route = {});

/// Theorem C for all singularities of a map, each within 10^-digits/2 of its place, relative to it below 1; the mirror
/// image of a proved one, of the same unknown, is proved by it. Calls `done` after each. One that is not proved has a
/// `refusal` and does not affect the others.
std::vector<proved_singularity> prove_singularities(const explicit_system& system,
                                                    const std::vector<found_singularity>& found, long digits,
                                                    const std::function<void()>& done = {},
                                                    const proof_route& route = {});

/// lower <= R <= upper.
struct proved_radius {
    /// No singularity at all, by the form of the equation.
    bool infinite = false;
    ball lower, upper;  ///< exact
    /// The discs of all coverings, those of the independent system with the nearest singularity first, and its symmetry.
    covering cover;
    int rotation = 1;
    /// How many independent systems with singularities were covered, each up to its own symmetry.
    std::size_t systems = 1;
    std::optional<found_singularity> nearest;
    std::optional<proved_singularity> evidence;
};

/// The radius of convergence about the start of the unknowns and their lower derivatives, that of the nearest singularity
/// of any of them, upper - lower < lower 10^-digits: the nearest singularity is found in rounded arithmetic, a loop next
/// to it bounds R from above (theorem C, in the subsystem of the unknown that has it) and coverings of the disc that does
/// not reach it, one for each weakly connected component, from below (theorem L). Throws error of the kind undecided with
/// what is proved so far where one of them fails.
proved_radius prove_radius(const explicit_system& system, long digits, const proof_route& route = {});

/// Its bounds as decimals, rounded outwards, with as few digits as keep upper - lower below lower 10^-digits; inf, inf
/// where it is infinite.
struct outward_bounds {
    std::string lower, upper;
};
outward_bounds outward_decimals(const proved_radius& radius, long digits);

}  // namespace libration::ode
