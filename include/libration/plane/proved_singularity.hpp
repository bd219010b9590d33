// Proofs of singularities and of the radius of convergence of any system, as found by a search: theorems L and C.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/plane/radius_bound.hpp"
#include "libration/plane/singularity_map.hpp"

namespace libration::ode {

/// A singularity of an unknown in a disc, and its evidence.
struct proved_singularity {
    complex_number<mpfr> centre;  ///< relative to the initial point
    magnitude reach;              ///< the radius of the disc about it
    /// For the unknown itself or one of its lower derivatives, whose index in the whole system it contains.
    loop_result evidence;
    /// The order if it is proved to be a pole, by a zero in regular coordinates; 0 otherwise.
    int pole_order = 0;
    /// The reason why it is not proved; empty if it is.
    std::string refusal = {};
};

/// Whether there is exactly one pole within `reach` of an exact offset, of the order given by regular_coordinates: the
/// path follows the corners from the initial point and half of the rest, then those coordinates up to a disc about the
/// offset m. Let q be the coordinate with a simple zero there, Q an enclosure of q' over the box Z of that reach about
/// m: if m - q(m)/Q lies inside Z, q has one zero in Z, which lies there (interval Newton: z -> m - q(m)/A(z), A(z) in
/// Q the mean slope between m and z, maps Z into it); at a pole of order 2, p = 0 implies v = 0 if the other factor of
/// p^2 excludes 0. False if it is not proved with so many bits.
bool is_pole_near(const explicit_system& system, const std::vector<complex_ball>& corners, const complex_ball& offset,
                  const magnitude& reach, long bits, const proof_route& route = {});

/// Theorem C for a singularity that was found to more digits: some path in a polygon within `reach` of its offset ends
/// in a singularity of the branch reached by its path, of the unknown that it was found for and not of another; and
/// whether that is a pole, if the equation of this unknown has regular coordinates. The path is continued in the
/// subsystem of the unknowns that this one depends on. The precision is increased until the loop closes. Throws error
/// of the kind undecided if no functional of this unknown excludes 0, or if a million bits do not suffice.
proved_singularity prove_singularity(const explicit_system& system, const found_singularity& found, const mpfr& reach,
                                     const proof_route& route = {});

/// Theorem C for all singularities of a map, each within 10^-digits/2 of its location, relative to it below 1; the
/// mirror image of a proved one, of the same unknown, is thereby proved. Calls `done` after each. An unproved one has
/// the reason in its `refusal` and does not affect the others, also if the progress callback ends its proof.
std::vector<proved_singularity> prove_singularities(const explicit_system& system,
                                                    const std::vector<found_singularity>& found, long digits,
                                                    const std::function<void()>& done = {},
                                                    const proof_route& route = {});

/// lower <= R <= upper.
struct proved_radius {
    /// Whether there is no singularity: by the form of the equation, or because the solution is constant.
    bool infinite = false;
    bool constant = false;
    ball lower, upper;  ///< exact
    /// The discs of all coverings, those of the independent system with the nearest singularity first, and the symmetry
    /// of that.
    covering cover;
    int rotation = 1;
    /// Number of covered independent systems with singularities, each up to its own symmetry.
    std::size_t systems = 1;
    std::optional<found_singularity> nearest;
    std::optional<proved_singularity> evidence;
};

/// The radius of convergence about the initial point of the unknowns and their lower derivatives, that of the nearest
/// singularity of any of them, upper - lower < lower 10^-digits: the nearest singularity is found in rounded
/// arithmetic, a loop around it bounds R from above (theorem C, in the subsystem of the unknown that has it) and
/// coverings of the disc up to just below it, one for each weakly connected component, from below (theorem L). A
/// constant solution (is_constant) has an infinite radius. Throws error of the kind undecided with the bounds proved so
/// far if one of them fails.
proved_radius prove_radius(const explicit_system& system, long digits, const proof_route& route = {});

/// Its bounds as decimals, rounded outwards, with the fewest digits that keep upper - lower below lower 10^-digits;
/// inf, inf if it is infinite.
struct outward_bounds {
    std::string lower, upper;
};
outward_bounds outward_decimals(const proved_radius& radius, long digits);

}  // namespace libration::ode
